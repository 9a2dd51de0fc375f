#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "can/hub/faults/faults.hpp"
#include "can/hub/medium/interfaces.hpp"
#include "can/hub/medium/medium.hpp"
#include "service/log.hpp"
#include "sim/base/told_time.hpp"
#include "sim/master/leader.hpp"
#include "sim/plan/world_plan.hpp"
#include "sim/unit/judge.hpp"
#include "sim/unit/simulated_unit.hpp"
#include "sim/world/wire_recorder.hpp"
#include "sim/world/world_disks.hpp"

namespace sim {

/// A bus with units and masters, in a time of its own, as a plan has it: all that happens follows from that. The
/// process has one at a time, which is its clock and its disk meanwhile.
class World {
 public:
  /// Of @p plan, which outlives this; what units log goes to @p log. Throws axisd::ConfigurationError.
  World(const WorldPlan& plan, const axisd::Log& log);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Runs to the end, or to the first breach of an invariant.
  std::optional<Breach> run();

  /// What has happened, for reports.
  struct Counts {
    std::uint64_t frames = 0;
    std::uint64_t turns = 0;  ///< of programs of units
    std::uint64_t power_ons = 0;
    std::uint64_t disk_operations = 0;
    double full_bus = 0.0;  ///< seconds in which the bus had no room
  };
  [[nodiscard]] Counts counts() const noexcept;
  [[nodiscard]] WireRecorder& wire() noexcept { return recorder_; }
  /// Seconds of the world until now.
  [[nodiscard]] double seconds() const noexcept;

  // What faults do; see fault_actions.cpp.
  [[nodiscard]] SimulatedUnit& unit(std::size_t number) noexcept { return *units_[number]; }
  [[nodiscard]] Leader& leader(std::size_t number) noexcept { return *leaders_[number]; }
  [[nodiscard]] hub::faults::Faults& bus_faults() noexcept { return faults_; }
  [[nodiscard]] canopen::TimePoint now() const noexcept { return time_.now(); }
  void switch_on(std::size_t number);

 private:
  /// A fault that begins or ends.
  struct Step {
    canopen::TimePoint at;
    const FaultPlan* fault;
    bool begins;
  };

  void add_units();
  void add_masters();
  void plan_faults();
  [[nodiscard]] canopen::TimePoint next_event() const noexcept;
  void go_to(canopen::TimePoint now);
  void step_faults();
  void calm_down();
  void run_bus() noexcept;
  void watch_load();
  void run_stations();
  void run_units();
  [[nodiscard]] std::optional<Breach> find_breach() const;

  const WorldPlan& plan_;
  const axisd::Log& log_;
  Draw draw_;
  ToldTime time_;
  hub::Clock clock_;
  hub::Medium medium_;
  hub::Interfaces interfaces_;
  hub::faults::Faults faults_;
  WireRecorder recorder_;
  WorldDisks disks_;
  std::vector<std::unique_ptr<Judge>> judges_;
  std::vector<axisd::Configuration> configurations_;
  std::vector<std::unique_ptr<SimulatedUnit>> units_;
  std::vector<std::unique_ptr<Leader>> leaders_;
  std::vector<std::unique_ptr<Station>> stations_;  ///< that are no leaders
  std::vector<Step> steps_;                         ///< in their order
  std::size_t next_step_ = 0;
  os::Disk& before_;  ///< the disk of the process outside of this world
  bool is_calm_ = false;
  canopen::TimePoint calm_;
  canopen::TimePoint end_;
  /// A time in which the load of the bus is looked at.
  struct Window {
    canopen::TimePoint begin = ToldTime::kBegin;
    std::uint64_t bits = 0;  ///< that had passed by then
  };
  Window window_{};
  std::uint64_t turns_ = 0;
  std::uint64_t power_ons_ = 0;
  canopen::Duration full_{};
};

}  // namespace sim
