#include "record/show.hpp"

#include <array>
#include <chrono>
#include <optional>
#include <type_traits>

#include <fmt/format.h>

#include "os/regular_file.hpp"
#include "record/candump.hpp"

namespace record {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kReasons{"stopped", "full", "over"};

double seconds(Moment at) noexcept {
  return std::chrono::duration<double>{at}.count();
}

std::string hex_of(const canopen::Frame& frame) {
  std::string text;
  for (std::size_t i = 0; i < frame.length; ++i) text += fmt::format("{:02X}", frame.data[i]);
  return text;
}

std::string identifier_of(const canopen::Frame& frame) {
  return frame.extended ? fmt::format("{:08X}", frame.id) : fmt::format("{:03X}", frame.id);
}

/// What a head says of itself; nothing if it is of another kind than expected.
template <class Value>
std::optional<Value> member(const json& head, const char* key) {
  const auto found = head.find(key);
  if (found == head.end()) return std::nullopt;
  if constexpr (std::is_same_v<Value, std::string>) {
    if (!found->is_string()) return std::nullopt;
  } else {
    if (!found->is_number_integer()) return std::nullopt;
  }
  return found->template get<Value>();
}

std::string name_of_signal(const json& head, std::size_t position) {
  const auto names = head.find("signals");
  if (names == head.end() || !names->is_array() || position >= names->size()) return fmt::format("{}", position);
  const json& signal = (*names)[position];
  return signal.is_object() ? member<std::string>(signal, "name").value_or("?") : "?";
}

/// Adds what a record of each type holds.
struct AddContent {
  json& line;
  const json& head;

  void operator()(const FrameRecord& record) const {
    line["type"] = "frame";
    line["direction"] = record.sent ? "sent" : "received";
    line["id"] = identifier_of(record.frame);
    if (record.frame.remote) {
      line["remote"] = record.frame.length;
    } else {
      line["data"] = hex_of(record.frame);
    }
  }
  void operator()(const Event& event) const {
    const json members = json_of(event, canopen::TimePoint{});
    line["type"] = "event";
    for (const auto& [key, value] : members.items())
      if (key != "t") line[key] = value;
  }
  void operator()(const SamplesRecord& record) const {
    line["type"] = "samples";
    json values = json::object();
    for (std::size_t i = 0; i < record.values.size(); ++i) values[name_of_signal(head, i)] = record.values[i];
    line["values"] = values;
  }
  void operator()(const LostRecord& record) const {
    line["type"] = "lost";
    line["records"] = record.records;
  }
  void operator()(const EndRecord& record) const {
    line["type"] = "end";
    line["reason"] = kReasons[static_cast<std::size_t>(record.reason)];
  }
};

std::string candump_of(const Record& record, const json& head) {
  const auto* const frame = std::get_if<FrameRecord>(&record.content);
  if (frame == nullptr) return {};
  const std::chrono::nanoseconds start{member<std::int64_t>(head, "wall_clock_ns").value_or(0)};
  std::string line =
      candump_line(frame->frame, start + record.at, member<std::string>(head, "interface").value_or("can0"));
  line.pop_back();
  return line;
}

std::string in_form(Form form, const Record& record, const json& head) {
  switch (form) {
    case Form::Text:
      return text_of(record, head);
    case Form::Json:
      return json_of(record, head).dump(-1, ' ', false, json::error_handler_t::replace);
    case Form::Candump:
      break;
  }
  return candump_of(record, head);
}

}  // namespace

json json_of(const Record& record, const json& head) {
  json line{{"t", seconds(record.at)}};
  std::visit(AddContent{line, head}, record.content);
  return line;
}

std::string text_of(const Record& record, const json& head) {
  const json line = json_of(record, head);
  std::string text = fmt::format("{:14.6f} {:8}", seconds(record.at), line.at("type").get<std::string>());
  if (const auto* const frame = std::get_if<FrameRecord>(&record.content)) {
    const auto content = frame->frame.remote ? fmt::format("R{}", frame->frame.length) : hex_of(frame->frame);
    return text +
           fmt::format(" {} {} {}", frame->sent ? "sent    " : "received", identifier_of(frame->frame), content);
  }
  const json& members = std::holds_alternative<SamplesRecord>(record.content) ? line.at("values") : line;
  if (const auto kind = line.find("kind"); kind != line.end()) text += ' ' + kind->get<std::string>();
  for (const auto& [key, value] : members.items()) {
    if (key == "type" || key == "t" || key == "kind") continue;
    text += fmt::format(" {}={}", key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text;
}

tl::expected<std::string, std::string> show(const std::string& path, Form form,
                                            const std::function<void(std::string_view)>& line) {
  const auto content = os::read_regular_file(path, kLongestFile);
  if (!content) return tl::unexpected{path + ": " + content.error().reason()};
  auto reader = Reader::open(std::as_bytes(std::span{*content}));
  if (!reader) return tl::unexpected{path + ": " + reader.error()};
  if (form == Form::Json)
    line(json{{"type", "head"}, {"head", reader->head()}}.dump(-1, ' ', false, json::error_handler_t::replace));
  while (const auto record = reader->next()) {
    const std::string text = in_form(form, *record, reader->head());
    if (!text.empty()) line(text);
  }
  return reader->remark().empty() ? std::string{} : path + ": " + reader->remark();
}

}  // namespace record
