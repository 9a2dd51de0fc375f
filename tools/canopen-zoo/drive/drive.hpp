#pragma once

#include <cstdint>
#include <optional>

#include "libcanopen/base/time.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "tools/canopen-zoo/drive/drive_flaws.hpp"

namespace zoo {

/// A drive of CiA 402-2 behind drive_objects(): its state machine, three modes, and an axis that follows every
/// ramp exactly. Time passes for it when it is told.
class Drive final : private canopen::EntryOwner {
 public:
  /// Boots. Owns some of the objects in @p dictionary, which outlives it.
  Drive(canopen::Dictionary& dictionary, const DriveFlaws& flaws, canopen::TimePoint now);

  /// The objects have their initial values again, or stored ones.
  void boot();
  /// Moves until @p now and shows where it is.
  void advance(canopen::TimePoint now);
  /// Takes what has been written and shows what comes of it.
  void act();
  /// The node has left Operational.
  void lose_connection();

 private:
  enum class State : std::uint8_t { Disabled, Ready, SwitchedOn, Enabled, QuickStop, Fault };

  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;

  std::int64_t get(std::uint16_t index, std::uint8_t sub_index = 0) const;
  void set(std::uint16_t index, std::int64_t value);
  bool halted() const noexcept;
  void command(std::uint16_t before);
  State after_command() const noexcept;
  State stopped_quickly() const noexcept;
  void go_to(State next);
  void follow_mode();
  void follow_set_points(std::uint16_t before);
  void take_set_point();
  std::int64_t within_limits(std::int64_t target) const;
  void home();
  void move();
  double wanted_velocity();
  double velocity_to_target();
  double highest_velocity() const;
  void arrive();
  std::uint16_t statusword() const;
  std::uint16_t mode_bits() const;
  void show();

  canopen::Dictionary* dictionary_;
  DriveFlaws flaws_;
  canopen::TimePoint now_;
  State state_ = State::Disabled;
  std::int64_t mode_ = 0;
  std::uint16_t word_ = 0;
  double position_ = 0, velocity_ = 0;
  std::optional<std::int64_t> target_{}, waiting_{};
  std::int64_t last_target_ = 0, last_written_ = 0;
  bool acknowledged_ = false, homed_ = false;
};

}  // namespace zoo
