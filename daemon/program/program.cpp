#include "daemon/program/program.hpp"

#include <sys/epoll.h>

#include "daemon/program/control_handlers.hpp"

namespace axisd {

Program::Unit::Unit(const Configuration& configuration, const std::filesystem::path& state_root, const Log& log,
                    InstanceListener& listener)
    : lock{state_root, configuration.address, configuration.node_id},
      instance{configuration, lock.directory(), log, listener} {
  if (configuration.node_id == kAddressSwitchOff) lock.serve(configuration.address, instance.device().node_id());
  instance.load();
}

Program::Program(std::span<const Assignment> assignments, const std::filesystem::path& state_root, const Log& log)
    : log_{log},
      notification_{assignments.size()},
      units_{make_units(assignments, state_root)},
      events_{[this] { stop(); }},
      loop_{*this} {
  loop_.watch(events_.descriptor());
  auto unit = units_.begin();
  for (const Assignment& assignment : assignments) {
    attach(unit->instance);
    if (!assignment.control.empty()) open_control(unit->instance, assignment.control);
    ++unit;
  }
  events_.dispatch();  // makes room for as many as are watched now, which it would do with the first of them
}

/// Before the signals are caught: whoever waits for a bus can be ended.
std::list<Program::Unit> Program::make_units(std::span<const Assignment> assignments,
                                             const std::filesystem::path& state_root) {
  std::list<Unit> units;
  for (const Assignment& assignment : assignments)
    units.emplace_back(assignment.configuration, state_root, log_, notification_);
  return units;
}

void Program::attach(Instance& instance) {
  loop_.add(instance.bus());
  for (const Instance::RareSource& source : instance.rare_sources()) {
    watched_.push_back(source);
    sources_.push_back(events_.watch(source.descriptor, EPOLLIN, &Program::on_rare, &watched_.back()));
  }
}

void Program::open_control(Instance& instance, const std::string& path) {
  controls_.emplace_back(events_, path, [this, &instance](std::string_view line) {
    return answer_request({instance, [this] { stop(); }}, line);
  });
}

int Program::on_rare(sd_event_source*, int, std::uint32_t, void* watched) noexcept {
  const auto& source = *static_cast<const Instance::RareSource*>(watched);
  (source.instance->*source.handle)();
  return 0;
}

void Program::on_chores(canopen::TimePoint now) noexcept {
  watchdog_.on_time(now);
  if (log_.due() <= now) log_.tell_left_out(now);
}

void Program::run() {
  for (Unit& unit : units_) unit.instance.start();
  while (!stopping_) {
    loop_.turn();
    for (Unit& unit : units_) unit.instance.look_around();
  }
  Notification::on_stopping();
  for (Unit& unit : units_) unit.instance.power_off();
  log_.info("power-off");
}

}  // namespace axisd
