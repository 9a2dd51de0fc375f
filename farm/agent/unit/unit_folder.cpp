#include "farm/agent/unit/unit_folder.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <span>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "checksum/crc32.hpp"
#include "control/socket_name.hpp"
#include "os/descriptor.hpp"
#include "os/regular_file.hpp"
#include "text/number.hpp"

namespace farm::agent {
namespace {

using nlohmann::json;

/// Of what a unit saves (bytes).
constexpr std::size_t kLongestFile = std::size_t{16} << 20;
/// Of a note (bytes): a configuration and little more.
constexpr std::size_t kLongestNote = std::size_t{1} << 20;
/// Node-ID of a unit that LSS has to give one.
constexpr int kNoNodeId = 255;
constexpr std::string_view kWithSerial = "unconfigured-";

/// 0 or the error.
int write_all(int descriptor, std::string_view content) noexcept {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

int write_file(const std::string& path, std::string_view content, Write write) noexcept {
  constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return errno;
  const os::Descriptor file{
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kOwnerOnly)};
  if (!file) return errno;
  if (const int error = write_all(file.get(), content)) return error;
  return write == Write::ToCache || ::fdatasync(file.get()) == 0 ? 0 : errno;
}

/// The content of the file at @p path; nothing if there is none, or what no program here has put there.
tl::expected<std::optional<std::string>, std::string> read_if_there(const std::string& path, std::size_t most) {
  auto content = os::read_regular_file(path, most);
  if (content) return *std::move(content);
  const os::UnreadableFile& why = content.error();
  if (why.is_missing() || why.why != os::UnreadableFile::Why::System) return std::nullopt;
  return tl::unexpected{fmt::format("{}: cannot be read: {}", path, why.reason())};
}

/// Serial number of a station without node-ID that has one.
std::optional<std::uint32_t> serial_of(std::string_view station) noexcept {
  if (!station.starts_with(kWithSerial)) return std::nullopt;
  return text::integer<std::uint32_t>(station.substr(kWithSerial.size()));
}

}  // namespace

std::string Folders::socket(const UnitName& unit) const {
  return fmt::format("{}/axisd-{}-{}.sock", runtime, unit.bus, unit.node);
}

std::string Folders::configuration(const UnitName& unit) const {
  return fmt::format("{}/{}.json", bus(unit.bus), unit.node);
}

std::string Folders::saved(const UnitName& unit) const {
  return fmt::format("{}/{}-{}", state, unit.bus, unit.node);
}

std::string Folders::parameters(const UnitName& unit) const {
  return saved(unit) + "/parameters.bin";
}

std::string Folders::note(const UnitName& unit) const {
  return saved(unit) + "/agent.json";
}

std::string text_of(const UnitNote& note) {
  json document{
      {"term", note.kept.term}, {"generation", note.kept.generation}, {"configuration", note.configuration}};
  if (note.uploaded) document["uploaded"] = *note.uploaded;
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<UnitNote> parse_unit_note(std::string_view text) {
  const json document = json::parse(text, nullptr, /*allow_exceptions=*/false);
  const auto has = [&](const char* key, auto is_kind) {
    return document.contains(key) && (document[key].*is_kind)();
  };
  if (!document.is_object() || !has("term", &json::is_number_unsigned) || !has("generation", &json::is_string) ||
      !has("configuration", &json::is_string))
    return std::nullopt;
  UnitNote note;
  note.kept = {document["term"].get<std::uint64_t>(), document["generation"].get<std::string>()};
  note.configuration = document["configuration"].get<std::string>();
  if (has("uploaded", &json::is_number_unsigned)) note.uploaded = document["uploaded"].get<std::uint32_t>();
  return note;
}

tl::expected<void, std::string> replace_file(const std::string& path, std::string_view content, Write write) {
  const std::filesystem::path folder = std::filesystem::path{path}.parent_path();
  const std::string next = path + ".new";
  std::error_code refused;
  if (std::filesystem::create_directories(folder, refused)) ::chmod(folder.c_str(), S_IRWXU);
  int error = refused ? refused.value() : write_file(next, content, write);
  if (error == 0 && ::rename(next.c_str(), path.c_str()) != 0) error = errno;
  if (error == 0) return {};
  return tl::unexpected{fmt::format("{}: cannot be written: {}", path, std::strerror(error))};
}

tl::expected<std::optional<std::string>, std::string> read_parameters(const Folders& folders,
                                                                      const UnitName& unit) {
  return read_if_there(folders.parameters(unit), kLongestFile);
}

tl::expected<std::optional<std::uint32_t>, std::string> checksum_of_parameters(const Folders& folders,
                                                                               const UnitName& unit) {
  const auto content = read_parameters(folders, unit);
  if (!content) return tl::unexpected{content.error()};
  if (!*content) return std::nullopt;
  return checksum::crc32(std::as_bytes(std::span{**content}));
}

tl::expected<UnitNote, std::string> read_note(const Folders& folders, const UnitName& unit) {
  const auto text = read_if_there(folders.note(unit), kLongestNote);
  if (!text) return tl::unexpected{text.error()};
  return parse_unit_note(text->value_or("")).value_or(UnitNote{});
}

tl::expected<std::string, std::string> configuration_file(const Folders& folders, const UnitName& unit,
                                                          const std::string& configuration) {
  json document = json::parse(configuration, nullptr, /*allow_exceptions=*/false);
  if (!document.is_object()) return tl::unexpected{std::string{"configuration: expected an object"}};
  document["interface"] = "unix:" + folders.hub(unit.bus);
  document["bus"] = unit.bus;
  const bool has_node_id = !control::is_unconfigured(unit.node);
  document["node_id"] = has_node_id ? text::integer<int>(unit.node).value_or(0) : kNoNodeId;
  if (const auto serial = serial_of(unit.node)) {
    if (document.value("serial", json(*serial)) != *serial)
      return tl::unexpected{fmt::format("configuration/serial: expected {}, as the key says, got {}", *serial,
                                        document["serial"].dump())};
    document["serial"] = *serial;
  }
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace farm::agent
