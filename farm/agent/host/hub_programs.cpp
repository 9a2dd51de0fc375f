#include "farm/agent/host/hub_programs.hpp"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "farm/agent/process/socket_server.hpp"
#include "os/folder.hpp"
#include "os/regular_file.hpp"

namespace farm::agent {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// How often it is looked whether a hub that was started serves its path.
constexpr std::chrono::milliseconds kLook{10};
constexpr std::size_t kLongestHubNote = std::size_t{64} << 10;

/// What a hub was started with, kept for the next agent.
struct HubNote {
  std::uint32_t bit_rate = 0;
  std::vector<std::string> words;
};

std::string text_of(const HubNote& note) {
  return json{{"bitrate", note.bit_rate}, {"words", note.words}}.dump(-1, ' ', false,
                                                                      json::error_handler_t::replace);
}

/// One that cannot be read is that of no hub of ours.
HubNote read_note(const std::string& path) {
  const auto text = os::read_regular_file(path, kLongestHubNote);
  const json document = json::parse(text.value_or(""), nullptr, /*allow_exceptions=*/false);
  if (!document.is_object() || !document.contains("bitrate") || !document["bitrate"].is_number_unsigned() ||
      !document.contains("words") || !document["words"].is_array())
    return {};
  HubNote note{.bit_rate = document["bitrate"].get<std::uint32_t>(), .words = {}};
  for (const json& word : document["words"]) note.words.push_back(word.is_string() ? word.get<std::string>() : "");
  return note;
}

}  // namespace

std::vector<std::string> HubCommand::words(const HubStart& start, const std::string& path) const {
  std::vector<std::string> words{program, "--path", path, "--join", fmt::format("{}/{}", server, start.bus)};
  words.insert(words.end(), options.begin(), options.end());
  if (start.bit_rate != 0) words.insert(words.end(), {"--bitrate", std::to_string(start.bit_rate)});
  return words;
}

void HubPrograms::find() {
  std::error_code error;
  for (const std::string& name : os::names_in(folders_.runtime))
    if (fs::exists(fs::path{folders_.runtime} / name / "hub.json", error)) find(name);
}

void HubPrograms::find(const std::string& bus) {
  const HubNote known = read_note(note(bus));
  if (known.words.empty()) return;
  auto process = server_of_bus(folders_.hub(bus));
  if (!process) return;
  hold(bus, *std::move(process));
  if (known.words == command_.words({bus, known.bit_rate}, folders_.hub(bus)))
    return outcomes_.on_hub_found(bus, known.bit_rate);
  hubs_[bus].process->end();
}

void HubPrograms::hold(const std::string& bus, ProcessHandle process) {
  Hub& hub = hubs_[bus];
  hub.owner = this;
  hub.bus = bus;
  hub.process = std::make_unique<WatchedProcess>(events_, std::move(process), [this, bus](const ProcessEnd& end) {
    hubs_.erase(bus);
    outcomes_.on_hub_ended(bus, fmt::format("canhub {}", end.how));
  });
}

void HubPrograms::start(const HubStart& start) {
  const std::string path = folders_.hub(start.bus);
  if (hubs_.contains(start.bus)) return outcomes_.on_hub_ended(start.bus, "the former hub has not ended yet");
  find(start.bus);  // one that could not be told from another one's before
  if (hubs_.contains(start.bus)) return;
  if (const auto other = server_of_bus(path))
    return outcomes_.on_hub_ended(
        start.bus, fmt::format("{}: served by process {}, which no agent has started", path, other->number));
  const HubNote kept{start.bit_rate, command_.words(start, path)};
  if (const auto written = replace_file(note(start.bus), text_of(kept)); !written)
    return outcomes_.on_hub_ended(start.bus, written.error());
  auto process = start_program({.words = kept.words, .variables = {}});
  if (!process) return outcomes_.on_hub_ended(start.bus, process.error());
  hold(start.bus, *std::move(process));
  Hub& hub = hubs_[start.bus];
  hub.look = events_.timer(
      [](sd_event_source*, std::uint64_t, void* userdata) noexcept {
        const Hub& it = *static_cast<Hub*>(userdata);
        it.owner->look_at(it.bus);
        return 0;
      },
      &hub);
  axisd::ServiceEvents::start(hub.look, kLook);
}

/// Until it serves or has ended.
void HubPrograms::look_at(const std::string& bus) {
  Hub& hub = hubs_.at(bus);
  const auto server = server_of_bus(folders_.hub(bus));
  if (!server || server->number != hub.process->number()) return axisd::ServiceEvents::start(hub.look, kLook);
  outcomes_.on_hub_started(bus);
}

void HubPrograms::stop(const std::string& bus) {
  if (const auto hub = hubs_.find(bus); hub != hubs_.end()) hub->second.process->end();
}

}  // namespace farm::agent
