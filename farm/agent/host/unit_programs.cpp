#include "farm/agent/host/unit_programs.hpp"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "control/socket_name.hpp"
#include "farm/agent/process/socket_server.hpp"
#include "os/folder.hpp"

namespace farm::agent {
namespace {

/// For so long others wait for a unit that does not say that it is on its bus.
constexpr std::chrono::seconds kPatience{5};
/// A unit whose hub is away waits for the next one, and starts none itself, which would be on no bus of a farm.
constexpr const char* kNoHub = "CAN_HUB=/nonexistent";

}  // namespace

std::vector<std::string> UnitCommand::words(const Folders& folders, const UnitName& unit) const {
  std::vector<std::string> words{program,      "--config",           folders.configuration(unit),
                                 "--control",  folders.socket(unit), "--state-directory",
                                 folders.state};
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

void UnitPrograms::find() {
  for (const std::string& file : os::names_in(folders_.runtime)) {
    const auto socket = control::parse_socket_name(file);
    if (!socket) continue;
    const UnitName name{std::string{socket->label}, std::string{socket->station}};
    auto process = server_of_socket(folders_.socket(name));
    const auto start = state_.noted(name);
    if (!process || !start || !*start) continue;
    Unit& unit = units_[name];
    unit.start = **start;
    hold(unit, *std::move(process));
    state_.begin(name);
    outcomes_.on_unit_found(**start);
  }
}

void UnitPrograms::start(UnitStart start) {
  const UnitName name = start.unit;
  if (units_.contains(name)) return outcomes_.on_unit_ended(name, "the former one has not ended yet");
  Unit& unit = units_[name];
  unit.start = std::move(start);
  unit.attempt = ++last_attempt_;
  waiting_.push_back(name);
  begin_next();
}

void UnitPrograms::begin_next() {
  while (starting_ < kMostStarting && !waiting_.empty()) {
    const auto unit = units_.find(waiting_.front());
    waiting_.pop_front();
    if (unit == units_.end() || unit->second.is_starting || unit->second.process) continue;
    unit->second.is_starting = true;
    ++starting_;
    begin(unit->second);
  }
}

void UnitPrograms::begin(Unit& unit) {
  const UnitName name = unit.start.unit;
  if (auto other = server_of_socket(folders_.socket(name))) return begin_beside(unit, *std::move(other));
  state_.prepare(unit.start,
                 [this, name, attempt = unit.attempt](const tl::expected<void, std::string>& prepared) {
                   launch(name, attempt, prepared);
                 });
}

/// Of an agent before it is the unit, which goes on if it is as wanted.
void UnitPrograms::begin_beside(Unit& unit, ProcessHandle other) {
  const UnitName name = unit.start.unit;
  const auto noted = state_.noted(name);
  if (!noted) return give_up(name, noted.error());
  if (!*noted)
    return give_up(name, fmt::format("{}: served by process {}, which no agent has started", folders_.socket(name),
                                     other.number));
  hold(unit, std::move(other));
  if ((*noted)->configuration != unit.start.configuration) return unit.process->end();
  state_.note(unit.start);
  on_ready(name);
}

/// It may have been stopped meanwhile, and started again.
void UnitPrograms::launch(const UnitName& name, std::uint64_t attempt,
                          const tl::expected<void, std::string>& prepared) {
  const auto unit = units_.find(name);
  if (unit == units_.end() || unit->second.attempt != attempt) return;
  if (!prepared) return give_up(name, prepared.error());
  auto process = spawn(unit->second);
  if (!process) return give_up(name, process.error());
  hold(unit->second, *std::move(process));
  await_ready(unit->second);
}

tl::expected<ProcessHandle, std::string> UnitPrograms::spawn(Unit& unit) {
  const UnitName& name = unit.start.unit;
  const auto content = configuration_file(folders_, name, unit.start.configuration);
  if (!content) return tl::unexpected{content.error()};
  const std::string path = folders_.configuration(name);
  if (auto written = replace_file(path, *content); !written) return tl::unexpected{std::move(written.error())};
  unit.ready = std::make_unique<ReadyMessage>(events_, path + ".ready", [this, name] { on_ready(name); });
  return start_program({.words = command_.words(folders_, name), .variables = {unit.ready->variable(), kNoHub}});
}

void UnitPrograms::hold(Unit& unit, ProcessHandle process) {
  unit.process = std::make_unique<WatchedProcess>(
      events_, std::move(process), [this, name = unit.start.unit](const ProcessEnd& end) { on_end(name, end); });
}

void UnitPrograms::await_ready(Unit& unit) {
  unit.owner = this;
  unit.patience = events_.timer(
      [](sd_event_source*, std::uint64_t, void* userdata) noexcept {
        const Unit& it = *static_cast<Unit*>(userdata);
        const UnitName name = it.start.unit;
        it.owner->on_ready(name);
        return 0;
      },
      &unit);
  axisd::ServiceEvents::start(unit.patience, kPatience);
}

void UnitPrograms::on_ready(const UnitName& name) {
  Unit& unit = units_.at(name);
  unit.ready.reset();
  unit.patience.reset();
  unit.is_starting = false;
  --starting_;
  state_.begin(name);
  outcomes_.on_unit_started(name);
  begin_next();
}

void UnitPrograms::on_end(const UnitName& name, const ProcessEnd& end) {
  Unit& unit = units_.at(name);
  const std::string why = fmt::format("axisd {}, the log of the agent says why", end.how);
  // One that an agent before had started keeps its locks, and is there only now.
  if (unit.is_starting) return adopt(unit) ? void() : give_up(name, why);
  units_.erase(name);
  state_.end(name);
  outcomes_.on_unit_ended(name, why);
}

bool UnitPrograms::adopt(Unit& unit) {
  const UnitName name = unit.start.unit;
  auto process = server_of_socket(folders_.socket(name));
  if (!process) return false;
  hold(unit, *std::move(process));
  on_ready(name);
  return true;
}

void UnitPrograms::give_up(const UnitName& name, const std::string& why) {
  if (units_.at(name).is_starting) --starting_;
  units_.erase(name);
  outcomes_.on_unit_ended(name, why);
  begin_next();
}

void UnitPrograms::stop(const UnitName& name) {
  const auto unit = units_.find(name);
  if (unit == units_.end()) return outcomes_.on_unit_ended(name, {});
  if (!unit->second.process) return give_up(name, {});
  unit->second.process->end();
}

}  // namespace farm::agent
