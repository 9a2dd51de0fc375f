#include "tools/axisctl/scenario/run/stations.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <fmt/format.h>

#include "os/clock.hpp"
#include "tools/axisctl/page/files.hpp"

namespace scenario {

using axisctl::program_folder;

namespace {

using nlohmann::json;
using Done = tl::expected<void, std::string>;

/// Longest time in which a hub or a unit is there.
constexpr std::chrono::seconds kStart{10};
constexpr std::chrono::milliseconds kAskAgain{1};
/// The boot-up message of a unit that has said over its control socket that it is there needs no longer.
constexpr std::chrono::milliseconds kBootUp{200};
/// What axisd says of a signal to be recorded that the unit does not have; it has sent nothing then.
constexpr std::string_view kNoSuchSignal{"record: signals: "};

std::string text_in(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream{path}.rdbuf();
  return text.str();
}

/// Waits for the end of @p process, but not for ever.
int end_of(Process& process) {
  const auto until = std::chrono::steady_clock::now() + kStart;
  while (std::chrono::steady_clock::now() < until) {
    if (const auto status = process.ended()) return *status;
    std::this_thread::sleep_for(kAskAgain);
  }
  return -1;
}

}  // namespace

Stations::~Stations() {
  if (time_) time_->leave();
  // Those that need the bus go first.
  for (auto& program : programs_) {
    const pid_t group = program->process ? program->process->identifier() : 0;
    program->process.reset();
    if (group != 0) workshop_.forget(group);
  }
  for (auto& unit : units_) unit->process.signal(SIGTERM);
  for (auto& unit : units_) {
    const pid_t group = unit->process.identifier();
    unit->process.stop();
    workshop_.forget(group);
  }
  if (hub_) {
    const pid_t group = hub_->identifier();
    hub_.reset();
    workshop_.forget(group);
  }
}

tl::expected<Process, std::string> Stations::launch(const Command& command) const {
  const os::Descriptor part = time_ ? time_->prepare_child() : os::Descriptor{};
  auto process = Process::start(command);
  if (process) workshop_.guard(process->identifier());
  return process;
}

Done Stations::start_bus() {
  if (!bus_.empty()) return {};
  const std::string path = bus_path();
  std::vector<std::string> words{program_folder() + "/canhub", "--path", path};
  // frames of a bus with a time of its own last
  if (wish_.empty() || scenario_.bit_rate != 0)
    words.insert(words.end(), {"--bitrate", std::to_string(scenario_.bit_rate)});
  if (!wish_.empty()) words.insert(words.end(), {"--time", wish_});
  auto hub = launch({.words = std::move(words), .log = workshop_.path("canhub.log")});
  if (!hub) return tl::unexpected{hub.error()};
  hub_ = std::make_unique<Process>(*std::move(hub));
  bus_ = "unix:" + path;
  const auto until = std::chrono::steady_clock::now() + kStart;
  while (text_in(hub_->log()).find("ready") == std::string::npos) {
    if (hub_->ended() || std::chrono::steady_clock::now() > until)
      return tl::unexpected{"canhub does not serve the bus: " + hub_->last_line()};
    std::this_thread::sleep_for(kAskAgain);
  }
  join_time();
  return {};
}

/// This program is the master of the run.
void Stations::join_time() {
  if (wish_.empty()) return;
  time_ = bus::TimeShare::join(*bus::parse_address(bus_), 0);
  if (time_) os::use_time(*time_);
}

std::string Stations::write_configuration(const UnitPlan& plan, Signals recorded) const {
  std::string path = workshop_.path(plan.name + ".json");
  const json config = recorded_ == Recorded::Yes ? with_recording(scenario_, plan, recorded) : plan.config;
  std::ofstream{path} << config.dump(2) << '\n';
  return path;
}

Done Stations::check_units() const {
  for (std::size_t i = 0; i < scenario_.units.size(); ++i) {
    const std::string path = write_configuration(scenario_.units[i], Signals::All);
    auto process = launch({.words = {program_folder() + "/axisd", "--check-config", "--config", path},
                           .log = workshop_.path("check.log")});
    if (!process) return tl::unexpected{process.error()};
    const int status = end_of(*process);
    workshop_.forget(process->identifier());
    if (status == 0) continue;
    std::string line = process->last_line();
    if (const std::size_t at = line.find(path); at != std::string::npos) line = line.substr(at + path.size());
    if (line.starts_with(": ")) line = line.substr(2);
    const std::string place = line.starts_with("/inject") ? "" : "/config";
    return tl::unexpected{fmt::format("/units/{}{}{}{}", i, place, line.starts_with('/') ? "" : ": ", line)};
  }
  return {};
}

void Stations::see_boot_up(const UnitPlan& plan, Bench& bench) {
  constexpr std::uint32_t kErrorControl = 0x700;
  const canopen::TimePoint until = bench.now() + kBootUp;
  std::size_t next = 0;
  while (bench.now() < until && !bench.interrupted()) {
    for (const auto& frames = bench.frames(); next < frames.size(); ++next)
      if (frames[next].frame.id == kErrorControl + plan.node_id && frames[next].frame.data[0] == 0) return;
    bench.wait(until);
  }
}

Done Stations::start_unit(const UnitPlan& plan, Signals recorded, Bench& bench) {
  const std::string socket = workshop_.path(plan.name + ".sock");
  auto process =
      launch({.words = {program_folder() + "/axisd", "--interface", bus_, "--control", socket, "--state-directory",
                        workshop_.path(plan.name), "--config", write_configuration(plan, recorded)},
              .log = workshop_.path(plan.name + ".log")});
  if (!process) return tl::unexpected{process.error()};
  const canopen::TimePoint until = bench.now() + kStart;
  while (true) {
    // A step may name a signal that the unit does not have: that is for the step to tell.
    const bool has_ended = process->ended().has_value();
    if (has_ended && recorded == Signals::All && process->last_line().find(kNoSuchSignal) != std::string::npos) {
      workshop_.forget(process->identifier());
      return start_unit(plan, Signals::OfAxes, bench);
    }
    if (has_ended) return tl::unexpected{fmt::format("unit {}: {}", plan.name, process->last_line())};
    if (bench.now() > until || bench.interrupted())
      return tl::unexpected{fmt::format("unit {}: it has not come up within {} s", plan.name, kStart.count())};
    auto client = std::filesystem::exists(socket) ? axisctl::Client::connect(socket)
                                                  : axisctl::fail(axisctl::ExitStatus::NotReachable, "");
    const auto status = client ? client->ask({"status"}) : tl::unexpected{client.error()};
    if (status && status->value("nmt_state", "Initialising") != "Initialising" &&
        status->value("/bus/link"_json_pointer, "down") == "up") {
      units_.push_back(std::make_unique<Unit>(Unit{plan, *std::move(process), *std::move(client)}));
      break;
    }
    bench.pass(bench.now() + kAskAgain);
  }
  see_boot_up(plan, bench);
  if (plan.on) return {};
  const auto off = units_.back()->client.ask({"unit.off"});
  if (!off) return tl::unexpected{fmt::format("unit {}: {}", plan.name, off.error().message)};
  return {};
}

Done Stations::start_units(Bench& bench) {
  for (const UnitPlan& plan : scenario_.units)
    if (Done done = start_unit(plan, Signals::All, bench); !done) return done;
  return {};
}

Done Stations::start_programs() {
  for (const ProgramPlan& plan : scenario_.programs) {
    programs_.push_back(std::make_unique<Program>(Program{plan}));
    if (plan.by_step) continue;
    if (Done done = start(*programs_.back()); !done) return done;
  }
  return {};
}

Done Stations::start(Program& program) {
  Command command{.words = program.plan.command, .log = workshop_.path(program.plan.name + ".log")};
  command.environment.emplace_back("AXISD_BUS", bus_);
  for (const auto& unit : units_)
    command.environment.emplace_back("AXISD_SOCKET_" + unit->plan.name, workshop_.path(unit->plan.name + ".sock"));
  constexpr std::string_view kUserBus = "unix:";
  if (bus_.starts_with(kUserBus)) {
    command.environment.emplace_back("CAN_BUS", bus_.substr(kUserBus.size()));
    const std::filesystem::path library =
        std::filesystem::path{program_folder()} / "../lib/axisd/libcan-preload.so";
    if (!wish_.empty()) command.environment.emplace_back("CAN_TIME", wish_);
    command.environment.emplace_back("LD_PRELOAD", library.lexically_normal().string());
  }
  auto process = launch(command);
  if (!process) return tl::unexpected{fmt::format("program {}: {}", program.plan.name, process.error())};
  program.process = std::make_unique<Process>(*std::move(process));
  return {};
}

Unit& Stations::unit(const json& keys) {
  const auto name = keys.find("unit");
  if (name == keys.end()) return *units_.front();
  return **std::ranges::find(units_, name->get<std::string>(),
                             [](const auto& unit) -> const std::string& { return unit->plan.name; });
}

Unit* Stations::find(const UnitPlan& plan) {
  const auto unit = std::ranges::find(units_, plan.name,
                                      [](const auto& there) -> const std::string& { return there->plan.name; });
  return unit == units_.end() ? nullptr : unit->get();
}

Program& Stations::program(const std::string& name) {
  return **std::ranges::find(programs_, name,
                             [](const auto& program) -> const std::string& { return program->plan.name; });
}

std::optional<std::string> Stations::find_lost() {
  if (hub_ && hub_->ended()) return "canhub has ended: " + hub_->last_line();
  for (const auto& unit : units_)
    if (const auto status = unit->process.ended())
      return fmt::format("unit {} has ended with status {}: {}", unit->plan.name, *status,
                         unit->process.last_line());
  return std::nullopt;
}

}  // namespace scenario
