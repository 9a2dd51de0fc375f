#include "motor/lockstep/lockstep.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "motor/data/control_period.hpp"
#include "motor/drive_train.hpp"

namespace motor {
namespace {

/// A run of fewer periods is not worth the way into lanes and back.
constexpr long kFewestPeriods = 4;
/// Largest group of lanes (bytes), and most lanes of one.
constexpr std::size_t kGroupSize = 32768;
constexpr std::size_t kMostLanes = 8;

/// The axes of a run: in groups of one kind, or each by itself.
class Lineup {
 public:
  Lineup(std::span<const AxisRun> axes, bool in_lanes, const LaneVariant& variant) noexcept : axes_{axes} {
    std::array<std::optional<LaneKind>, kMostAxesInLockstep> kinds{};
    if (in_lanes)
      for (std::size_t i = 0; i < axes.size(); ++i) kinds[i] = axes[i].train->lane_kind(axes[i].command);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (taken_[i]) continue;
      const Places alike = alike_from(i, kinds, variant.lanes);
      if (alike.count < 2 || variant.size > kGroupSize)
        leave_alone(i);
      else
        form(alike, *kinds[i], variant);
    }
  }
  /// Period @p period with the link at @p dc_voltage (V); false if a current has tripped.
  bool step(std::size_t period, double dc_voltage) noexcept {
    bool sound = true;
    for (std::size_t i = 0; i < groups_; ++i)
      sound = group_[i]->step(period, dc_voltage, drawn_.data() + first_[i]) && sound;
    for (std::size_t i = 0; i < singles_; ++i) {
      const AxisRun& axis = axes_[single_[i]];
      drawn_[slot_[single_[i]]] = axis.train->step(dc_voltage, command(axis, period));
      sound = sound && !(axis.train->signals().current > axis.trip_current);
    }
    return sound;
  }
  /// Energy that all axes have drawn in that period (J), summed in their order.
  double drawn() const noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < axes_.size(); ++i) sum += drawn_[slot_[i]];
    return sum;
  }
  void leave() noexcept {
    for (std::size_t i = 0; i < groups_; ++i) group_[i]->leave();
  }

 private:
  /// Of some axes.
  struct Places {
    std::array<std::uint8_t, kMostAxesInLockstep> place{};
    std::size_t count = 0;
  };
  using Kinds = std::array<std::optional<LaneKind>, kMostAxesInLockstep>;

  static DriveCommand command(const AxisRun& axis, std::size_t period) noexcept {
    DriveCommand result = axis.command;
    if (axis.setpoints.empty()) return result;
    result.speed_setpoint = axis.setpoints[period].speed;
    result.acceleration_setpoint = axis.setpoints[period].acceleration;
    return result;
  }
  /// The axes of the kind of the one at @p first, from there on and not more than @p most.
  Places alike_from(std::size_t first, const Kinds& kinds, std::size_t most) const noexcept {
    Places result;
    if (!kinds[first]) return result;
    for (std::size_t i = first; i < axes_.size() && result.count < most; ++i)
      if (!taken_[i] && kinds[i] == kinds[first]) result.place[result.count++] = static_cast<std::uint8_t>(i);
    return result;
  }
  void leave_alone(std::size_t place) noexcept {
    single_[singles_++] = static_cast<std::uint8_t>(place);
    slot_[place] = slots_++;
  }
  void form(const Places& alike, const LaneKind& kind, const LaneVariant& variant) noexcept {
    const std::span<const std::uint8_t> places{alike.place.data(), alike.count};
    first_[groups_] = slots_;
    for (const std::uint8_t place : places) {
      taken_[place] = true;
      slot_[place] = slots_++;
    }
    slots_ = first_[groups_] + variant.lanes;
    group_[groups_] = variant.form(room_[groups_].bytes.data(), kind, axes_, places);
    ++groups_;
  }

  struct alignas(64) Room {
    std::array<std::byte, kGroupSize> bytes;
  };

  std::span<const AxisRun> axes_;
  std::array<bool, kMostAxesInLockstep> taken_{};
  std::array<std::uint8_t, kMostAxesInLockstep> single_{};
  std::size_t singles_ = 0;
  std::array<LaneGroup*, kMostAxesInLockstep / 2> group_{};
  std::size_t groups_ = 0;
  // Of energies: a group has one for each of its lanes.
  std::array<std::size_t, kMostAxesInLockstep / 2> first_{};
  std::array<std::size_t, kMostAxesInLockstep> slot_{};
  std::size_t slots_ = 0;
  std::array<double, kMostAxesInLockstep / 2 * kMostLanes> drawn_;
  std::array<Room, kMostAxesInLockstep / 2> room_;
};

}  // namespace

RunResult run(std::span<const AxisRun> axes, DcLink& link, long periods, double overvoltage,
              const LaneVariant& variant) noexcept {
  const bool pulses = std::ranges::any_of(axes, [](const AxisRun& axis) { return axis.command.pulses_enabled; });
  Lineup lineup{axes, periods >= kFewestPeriods, variant};
  const double most = pulses ? overvoltage : std::numeric_limits<double>::infinity();
  double voltage = link.voltage();
  double lowest = voltage;
  double highest = voltage;
  long period = 0;
  for (bool sound = true; sound && period < periods; ++period) {
    voltage = link.voltage();
    sound = lineup.step(static_cast<std::size_t>(period), voltage) && !(voltage > most);
    link.step(kControlPeriod, lineup.drawn());
    lowest = std::min(lowest, voltage);
    highest = std::max(highest, voltage);
  }
  lineup.leave();
  return {period, lowest, highest, voltage};
}

}  // namespace motor
