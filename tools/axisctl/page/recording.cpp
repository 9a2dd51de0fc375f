#include "tools/axisctl/page/recording.hpp"

#include <filesystem>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "can/port/address.hpp"
#include "os/regular_file.hpp"
#include "record/reader.hpp"
#include "record/show.hpp"

namespace axisctl {

using nlohmann::json;

std::string Recording::unit() const {
  const json unit = head.is_object() ? head.value("unit", json{}) : json{};
  if (!unit.is_string()) return "?";
  const auto& text = unit.get_ref<const std::string&>();
  const std::size_t slash = text.rfind('/');
  return slash == std::string::npos ? text
                                    : unit_name(text.substr(0, slash), std::string_view{text}.substr(slash + 1));
}

std::size_t Recording::axes() const {
  const json axes = head.is_object() ? head.value("axes", json{}) : json{};
  return axes.is_array() ? axes.size() : 0;
}

std::string Recording::profile() const {
  const json profile = head.is_object() ? head.value("profile", json{}) : json{};
  return profile.is_string() ? profile.get<std::string>() : "";
}

std::int64_t Recording::start() const {
  const json start = head.is_object() ? head.value("wall_clock_ns", json{}) : json{};
  return start.is_number_integer() ? start.get<std::int64_t>() : 0;
}

std::string unit_name(const std::string& interface, std::string_view node) {
  const auto address = bus::parse_address(interface);
  return fmt::format("{}/{}", address ? bus::label(*address) : interface, node);
}

Expected<Recording> read_recording(const std::string& path) {
  auto content = os::read_regular_file(path, record::kLongestFile);
  if (!content) {
    const ExitStatus status = content.error().is_missing() ? ExitStatus::NotThere : ExitStatus::Failed;
    return fail(status, path + ": " + content.error().reason());
  }
  Recording recording{.name = std::filesystem::path{path}.filename().string(), .content = *std::move(content)};
  auto reader = record::Reader::open(std::as_bytes(std::span{recording.content}));
  if (!reader) return fail(ExitStatus::NotThere, path + ": " + reader.error());
  recording.head = reader->head();
  while (reader->next()) continue;
  if (const std::string remark = reader->remark(); !remark.empty()) recording.remark = path + ": " + remark;
  return recording;
}

Expected<std::vector<Recording>> read_halves(const std::string& path) {
  std::filesystem::path older{path};
  older.replace_extension(".1.axrec");
  std::vector<Recording> halves;
  std::error_code ignored;
  for (const std::string& part : {older.string(), path}) {
    if (part != path && !std::filesystem::exists(part, ignored)) continue;
    auto recording = read_recording(part);
    if (!recording) return tl::unexpected{recording.error()};
    halves.push_back(*std::move(recording));
  }
  return halves;
}

}  // namespace axisctl
