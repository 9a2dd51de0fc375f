#include "tests/fuzz/readers/readers.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include <fmt/format.h>

namespace fuzz {
namespace {

constexpr std::size_t kLongestMessage = 4096;

constexpr std::array kReaders{
    ReaderRow{"configuration", "configuration files of axisd", "", made_configurations, read_configuration},
    ReaderRow{"motor", "motor files", "motors", nullptr, read_motor},
    ReaderRow{"scenario", "scenarios of axisctl run", "scenarios", nullptr, read_scenario},
    ReaderRow{"fault", "faults as words and as JSON", "", made_faults, read_fault},
    ReaderRow{"plan", "plans of axisd-sim", "", made_plans, read_plan},
    ReaderRow{"request", "lines of the control protocol, and words of axisctl", "", made_requests, read_request},
    ReaderRow{"candump", "logs of candump", "tests/audit/logs", nullptr, read_candump},
    ReaderRow{"recording", "recordings", "", made_recordings, read_recording},
    ReaderRow{"parameters", "saved parameters", "", made_parameters, read_parameters},
    ReaderRow{"retained", "what a unit keeps without being told", "", made_retained, read_retained},
    ReaderRow{"objects", "saved objects of a CiA 402 device", "", made_objects, read_objects},
    ReaderRow{"control", "requests to a unit over the control socket", "", made_control, read_control},
    ReaderRow{"http", "requests of HTTP", "", made_http, read_http},
    ReaderRow{"hub", "messages of programs to the hub of a bus", "", made_hub, read_hub},
    ReaderRow{"unit", "frames, time and faults for a drive unit", "", made_frames, read_frames},
    ReaderRow{"unit402", "the same for a CiA 402 device", "", made_frames, read_frames_402},
};

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

}  // namespace

std::span<const ReaderRow> readers() noexcept {
  return kReaders;
}

const ReaderRow* find_reader(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(kReaders, name, &ReaderRow::name);
  return row == kReaders.end() ? nullptr : row;
}

std::vector<std::string> inputs_of(const ReaderRow& reader) {
  std::vector<std::string> inputs;
  if (reader.made != nullptr) inputs = reader.made();
  if (reader.folder.empty()) return inputs;
  std::set<std::filesystem::path> paths;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator{std::filesystem::path{SOURCE_FOLDER} / reader.folder})
    if (entry.is_regular_file()) paths.insert(entry.path());
  for (const std::filesystem::path& path : paths) inputs.push_back(content_of(path));
  return inputs;
}

std::string message_rule(std::string_view message) {
  if (message.empty()) return "a refusal without a message";
  if (message.size() > kLongestMessage) return fmt::format("a message of {} bytes", message.size());
  const auto* const bad =
      std::ranges::find_if(message, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (bad == message.end()) return "";
  return fmt::format("byte {:02X}h in the message \"{}\"", static_cast<unsigned>(*bad), message);
}

}  // namespace fuzz
