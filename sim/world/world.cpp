#include "sim/world/world.hpp"

#include <algorithm>
#include <chrono>

#include "daemon/configuration/configuration.hpp"
#include "daemon/program/motor_folders.hpp"
#include "os/clock.hpp"
#include "os/disk.hpp"
#include "sim/judges/table.hpp"
#include "sim/master/guardian.hpp"
#include "sim/master/intruder.hpp"
#include "sim/master/sync_producer.hpp"
#include "sim/world/fault_actions.hpp"

namespace sim {
namespace {

constexpr canopen::Duration kGuardTime = std::chrono::milliseconds{300};

LeaderPlan leader_plan(const UnitPlan& unit, const axisd::Configuration& configuration) {
  return {.node_id = static_cast<std::uint8_t>(configuration.node_id),
          .axes = static_cast<unsigned>(configuration.axes.size()),
          .is_cia402 = configuration.profile() == axisd::Profile::Cia402,
          .heartbeat_ms = unit.heartbeat_ms,
          .inhibit_100us = unit.inhibit_100us,
          .transmission = unit.transmission,
          .by_rpdo = unit.by_rpdo,
          .stores = unit.stores,
          .restarts = unit.restarts,
          .seed = unit.seed};
}

}  // namespace

World::World(const WorldPlan& plan, const axisd::Log& log)
    : plan_{plan},
      log_{log},
      draw_{plan.seed},
      clock_{userbus::TimeWish{userbus::TimeMode::Virtual, 1.0}},
      medium_{plan.bit_rate, clock_},
      faults_{medium_, interfaces_},
      recorder_{medium_, time_},
      judges_{make_judges(plan.units.size())},
      before_{os::disk()},
      calm_{ToldTime::kBegin + plan.calm},
      end_{ToldTime::kBegin + plan.length} {
  os::use_time(time_);
  os::use_disk(disks_);
  clock_.set(time_.now());
  add_units();
  add_masters();
  plan_faults();
}

World::~World() {
  units_.clear();
  os::other_time = nullptr;
  os::use_disk(before_);
}

void World::add_units() {
  const axisd::MotorFolders motors;
  for (const UnitPlan& unit : plan_.units)
    configurations_.push_back(axisd::parse_configuration(unit.configuration.dump(), "plan", motors).units.front());
  const UnitSite site{medium_, time_, log_, judges_};
  for (std::size_t i = 0; i < plan_.units.size(); ++i) {
    units_.push_back(std::make_unique<SimulatedUnit>(site, i, configurations_[i], plan_.units[i].is_watched,
                                                     Draw{plan_.units[i].seed}));
    disks_.add(units_.back()->disk());
  }
  for (std::size_t i = 0; i < units_.size(); ++i) switch_on(i);
}

void World::add_masters() {
  for (std::size_t i = 0; i < plan_.units.size(); ++i) {
    const UnitPlan& unit = plan_.units[i];
    const std::uint8_t node_id = units_[i]->node_id();
    Draw draw{unit.seed + 1};
    leaders_.push_back(std::make_unique<Leader>(medium_, "leader", leader_plan(unit, configurations_[i]), calm_));
    if (unit.is_guarded)
      stations_.push_back(std::make_unique<Guardian>(medium_, node_id, kGuardTime, draw.fork()));
    if (unit.is_intruded) stations_.push_back(std::make_unique<Intruder>(medium_, node_id, calm_, draw.fork()));
  }
  if (plan_.sync > canopen::Duration{0})
    stations_.push_back(std::make_unique<SyncProducer>(medium_, plan_.sync, Draw{plan_.seed + 1}));
}

void World::plan_faults() {
  for (const FaultPlan& fault : plan_.faults) {
    const canopen::TimePoint begin = ToldTime::kBegin + fault.at;
    steps_.push_back({begin, &fault, true});
    steps_.push_back({std::min(begin + fault.lasting, calm_), &fault, false});
  }
  std::ranges::stable_sort(steps_, {}, &Step::at);
}

void World::switch_on(std::size_t number) {
  if (units_[number]->is_on()) return;
  ++power_ons_;
  units_[number]->switch_on();
}

std::optional<Breach> World::run() {
  while (true) {
    if (auto breach = find_breach()) return breach;
    const canopen::TimePoint next = next_event();
    if (next > end_) break;
    go_to(next);
  }
  time_.set(end_);
  for (const auto& judge : judges_) judge->on_end(end_);
  return find_breach();
}

canopen::TimePoint World::next_event() const noexcept {
  canopen::TimePoint next = medium_.next_deadline();
  if (next_step_ < steps_.size()) next = std::min(next, steps_[next_step_].at);
  if (!is_calm_) next = std::min(next, calm_);
  for (const auto& leader : leaders_) next = std::min(next, leader->next_deadline());
  for (const auto& station : stations_) next = std::min(next, station->next_deadline());
  for (const auto& unit : units_) next = std::min(next, unit->next_deadline());
  return std::max(next, time_.now());
}

void World::go_to(canopen::TimePoint now) {
  time_.set(now);
  clock_.set(now);
  step_faults();
  run_bus();
  watch_load();
  run_stations();
  run_units();
}

void World::step_faults() {
  while (next_step_ < steps_.size() && steps_[next_step_].at <= time_.now()) {
    const Step& step = steps_[next_step_++];
    if (step.begins) {
      begin_fault(*this, *step.fault);
    } else {
      end_fault(*this, *step.fault);
    }
  }
  if (!is_calm_ && calm_ <= time_.now()) calm_down();
}

/// Whatever is still wrong is mended.
void World::calm_down() {
  is_calm_ = true;
  faults_.take_back(std::nullopt);
  for (std::size_t i = 0; i < units_.size(); ++i) {
    switch_on(i);
    units_[i]->instance().faults().remove_all();
    units_[i]->refresh();
  }
  for (const auto& judge : judges_) judge->on_calm(time_.now());
}

void World::run_bus() noexcept {
  while (medium_.next_deadline() <= time_.now()) medium_.on_time(time_.now());
}

void World::watch_load() {
  constexpr canopen::Duration kWindow = std::chrono::milliseconds{100};
  constexpr double kFull = 0.95;  // of all bits
  const canopen::Duration lasting = time_.now() - window_.begin;
  if (lasting < kWindow) return;
  const auto bits = static_cast<double>(recorder_.bits() - window_.bits);
  window_ = {.begin = time_.now(), .bits = recorder_.bits()};
  if (bits < kFull * plan_.bit_rate * std::chrono::duration<double>(lasting).count()) return;
  full_ += lasting;
  for (const auto& judge : judges_) judge->on_full_bus(lasting);
}

void World::run_stations() {
  const auto run = [this](Station& station) {
    if (station.next_deadline() <= time_.now()) station.turn(time_.now());
  };
  for (const auto& leader : leaders_) run(*leader);
  for (const auto& station : stations_) run(*station);
}

/// Those that are due at the same time have no order; chance has one.
void World::run_units() {
  const std::size_t first = units_.size() > 1 ? draw_.below(units_.size()) : 0;
  for (std::size_t i = 0; i < units_.size(); ++i) {
    SimulatedUnit& unit = *units_[(first + i) % units_.size()];
    if (unit.next_deadline() > time_.now()) continue;
    unit.turn();
    ++turns_;
  }
}

std::optional<Breach> World::find_breach() const {
  for (const auto& judge : judges_)
    if (judge->breach()) return judge->breach();
  return std::nullopt;
}

World::Counts World::counts() const noexcept {
  Counts counts{.frames = recorder_.frames(),
                .turns = turns_,
                .power_ons = power_ons_,
                .full_bus = std::chrono::duration<double>(full_).count()};
  for (const auto& unit : units_) counts.disk_operations += unit->disk().operations();
  return counts;
}

double World::seconds() const noexcept {
  return std::chrono::duration<double>(time_.now() - ToldTime::kBegin).count();
}

}  // namespace sim
