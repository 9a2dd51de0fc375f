#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "daemon/configuration/configuration.hpp"
#include "daemon/instance/instance.hpp"
#include "service/log.hpp"
#include "sim/base/draw.hpp"
#include "sim/base/told_time.hpp"
#include "sim/disk/simulated_disk.hpp"
#include "sim/unit/judge.hpp"
#include "sim/wire/simulated_port.hpp"

namespace sim {

/// What the units of a world have in common.
struct UnitSite {
  hub::Medium& medium;
  const ToldTime& time;
  const axisd::Log& log;
  std::span<const std::unique_ptr<Judge>> judges;
};

/// One unit of a world, as axisd runs it: its instance while it is on, its disk, its interface, and the processor
/// that lets it run a little late. Judges see all that it does.
class SimulatedUnit final : private PortListener, private axisd::InstanceListener, private unit::CycleObserver {
 public:
  /// The unit that @p configuration says, number @p number (from 0) of the world, with its state in @p folder of
  /// its disk; off at first. @p is_watched: judges see each cycle, and the unit does not rest.
  SimulatedUnit(const UnitSite& site, std::size_t number, const axisd::Configuration& configuration,
                bool is_watched, Draw draw);
  ~SimulatedUnit() override;
  SimulatedUnit(const SimulatedUnit&) = delete;
  SimulatedUnit& operator=(const SimulatedUnit&) = delete;

  /// Power-on; nothing if it is on.
  void switch_on();
  /// The power fails: nothing is written any more.
  void cut_power() noexcept;
  /// It is switched off as a service is: what survives is written.
  void switch_off() noexcept;
  [[nodiscard]] bool is_on() const noexcept { return instance_ != nullptr; }

  /// Its program does not run until @p until.
  void stall(canopen::TimePoint until) noexcept { stalled_until_ = std::max(stalled_until_, until); }
  /// When it has run again, or will.
  [[nodiscard]] canopen::TimePoint stalled_until() const noexcept { return stalled_until_; }
  /// Its interface goes down, or comes up.
  void set_link(bool up) noexcept;
  /// Its controller is in @p state.
  void set_error_state(bus::ErrorState state) noexcept;

  /// When turn() is wanted; kNever: not before something happens.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;
  /// Its program has the processor.
  void turn() noexcept;
  /// Something beside its turns may have changed what it waits for, see axisd::EventLoop::refresh().
  void refresh() noexcept;

  [[nodiscard]] std::size_t number() const noexcept { return number_; }
  [[nodiscard]] std::uint8_t node_id() const noexcept { return static_cast<std::uint8_t>(configuration_.node_id); }
  [[nodiscard]] const axisd::Configuration& configuration() const noexcept { return configuration_; }
  /// While it is on.
  [[nodiscard]] axisd::Instance& instance() noexcept { return *instance_; }
  [[nodiscard]] const axisd::Instance& instance() const noexcept { return *instance_; }
  [[nodiscard]] SimulatedDisk& disk() noexcept { return disk_; }
  [[nodiscard]] const SimulatedDisk& disk() const noexcept { return disk_; }
  /// The file of its saved parameters.
  [[nodiscard]] std::string parameter_file() const { return folder_ / "parameters.bin"; }

 private:
  /// Which of Instance::rare_sources() is meant.
  enum class Rare : std::uint8_t { WriteEnded, Link };

  // PortListener
  void on_arrival() noexcept override;
  void on_taken(const canopen::Frame& frame) noexcept override;
  void on_sent(const canopen::Frame& frame) noexcept override;
  // axisd::InstanceListener
  void on_condition(const axisd::Instance&, axisd::Condition) noexcept override {}
  void on_event(const axisd::Instance& instance, const axisd::UnitEvent& event) noexcept override;
  // unit::CycleObserver
  void on_cycle_begin(unit::TimePoint) noexcept override {}
  void on_step(long) noexcept override;
  void on_cycle_end() noexcept override;

  template <class Tell>
  void tell(Tell tell) noexcept;
  void handle(Rare source) noexcept;
  void plan_turn() noexcept;
  void note_writes() noexcept;
  void leave() noexcept;

  const UnitSite site_;
  std::size_t number_;
  const axisd::Configuration& configuration_;
  bool is_watched_;
  Draw draw_;
  std::filesystem::path folder_;
  SimulatedDisk disk_;
  hub::Identity identity_;
  SimulatedPort* port_ = nullptr;  ///< of the instance
  SimulatedLink* link_ = nullptr;
  std::unique_ptr<axisd::Instance> instance_;
  bool link_is_up_ = true;
  canopen::TimePoint wake_ = canopen::kNever;
  canopen::TimePoint stalled_until_{};
  std::uint64_t operations_seen_ = 0;
  canopen::TimePoint write_ends_ = canopen::kNever;
};

}  // namespace sim
