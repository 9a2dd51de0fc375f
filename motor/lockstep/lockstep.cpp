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
/// Largest group of lanes (bytes), and most lanes of one. The room for all groups is on the stack, every page of
/// which costs a run something.
constexpr std::size_t kGroupSize = 18432;
constexpr std::size_t kMostLanes = 8;
/// Axes of further kinds are calculated each by itself.
constexpr std::size_t kMostGroups = 4;

/// The axes of a run: in groups of one kind, or each by itself.
class Lineup {
 public:
  Lineup(std::span<const LinkedAxes> units, bool in_lanes, const LaneVariant& variant) noexcept {
    std::array<std::optional<LaneKind>, kMostAxesInLockstep> kinds{};
    for (const LinkedAxes& unit : units)
      for (const AxisRun& axis : unit.axes) {
        if (in_lanes) kinds[count_] = axis.train->lane_kind(axis.command);
        axes_[count_++] = {&axis, &unit.result.last_dc_voltage};
      }
    for (std::size_t i = 0; i < count_; ++i) {
      if (taken_[i]) continue;
      const Places alike = alike_from(i, kinds, variant.lanes);
      if (alike.count < 2 || groups_ == kMostGroups || variant.size > kGroupSize)
        leave_alone(i);
      else
        form(alike, *kinds[i], variant);
    }
  }
  /// Period @p period with the links as their results tell; false if a current has tripped.
  bool step(std::size_t period) noexcept {
    bool sound = true;
    for (std::size_t i = 0; i < groups_; ++i) sound = group_[i]->step(period, drawn_.data() + first_[i]) && sound;
    for (std::size_t i = 0; i < singles_; ++i) {
      const AxisRun& axis = *axes_[single_[i]].run;
      drawn_[slot_[single_[i]]] = axis.train->step(*axes_[single_[i]].dc_voltage, command(axis, period));
      sound = sound && !(axis.train->signals().current > axis.trip_current);
    }
    return sound;
  }
  /// Energy that the @p count axes from @p first on have drawn in that period (J), summed in their order.
  double drawn(std::size_t first, std::size_t count) const noexcept {
    double sum = 0.0;
    for (std::size_t i = first; i < first + count; ++i) sum += drawn_[slot_[i]];
    return sum;
  }
  void leave() noexcept {
    for (std::size_t i = 0; i < groups_; ++i) group_[i]->leave();
  }

 private:
  /// Of some axes.
  struct Places {
    std::array<std::uint8_t, kMostAxesInLockstep> place;
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
    for (std::size_t i = first; i < count_ && result.count < most; ++i)
      if (!taken_[i] && kinds[i] == kinds[first]) result.place[result.count++] = static_cast<std::uint8_t>(i);
    return result;
  }
  void leave_alone(std::size_t place) noexcept {
    single_[singles_++] = static_cast<std::uint8_t>(place);
    slot_[place] = slots_++;
  }
  void form(const Places& alike, const LaneKind& kind, const LaneVariant& variant) noexcept {
    std::array<LaneAxis, kMostAxesInLockstep> axes;
    first_[groups_] = slots_;
    for (std::size_t i = 0; i < alike.count; ++i) {
      taken_[alike.place[i]] = true;
      axes[i] = axes_[alike.place[i]];
      slot_[alike.place[i]] = slots_ + i;
    }
    slots_ += variant.lanes;
    group_[groups_] = variant.form(room_[groups_].bytes.data(), kind, std::span{axes}.first(alike.count));
    ++groups_;
  }

  struct alignas(64) Room {
    std::array<std::byte, kGroupSize> bytes;
  };
  static constexpr std::size_t kMostSlots = kMostGroups * kMostLanes + kMostAxesInLockstep;

  std::array<LaneAxis, kMostAxesInLockstep> axes_;
  std::size_t count_ = 0;
  std::array<bool, kMostAxesInLockstep> taken_{};
  std::array<std::uint8_t, kMostAxesInLockstep> single_;
  std::size_t singles_ = 0;
  std::array<LaneGroup*, kMostGroups> group_;
  std::size_t groups_ = 0;
  // Of energies: a group has one for each of its lanes.
  std::array<std::size_t, kMostGroups> first_;
  std::array<std::size_t, kMostAxesInLockstep> slot_;
  std::size_t slots_ = 0;
  std::array<double, kMostSlots> drawn_;
  std::array<Room, kMostGroups> room_;
};

/// Above which @p unit ends a run (V).
double highest_allowed(const LinkedAxes& unit) noexcept {
  const bool pulses =
      std::ranges::any_of(unit.axes, [](const AxisRun& axis) { return axis.command.pulses_enabled; });
  return pulses ? unit.overvoltage : std::numeric_limits<double>::infinity();
}

void see_link(LinkedAxes& unit) noexcept {
  const double voltage = unit.link->voltage();
  unit.result.lowest_dc_voltage = std::min(unit.result.lowest_dc_voltage, voltage);
  unit.result.highest_dc_voltage = std::max(unit.result.highest_dc_voltage, voltage);
  unit.result.last_dc_voltage = voltage;
}

}  // namespace

long run_together(std::span<LinkedAxes> units, long periods, const LaneVariant& variant) noexcept {
  std::array<double, kMostAxesInLockstep> highest;
  std::ranges::transform(units, highest.begin(), highest_allowed);
  for (LinkedAxes& unit : units) {
    const double voltage = unit.link->voltage();
    unit.result = {0, voltage, voltage, voltage};
  }
  Lineup lineup{units, periods >= kFewestPeriods, variant};
  long period = 0;
  for (bool sound = true; sound && period < periods; ++period) {
    for (std::size_t i = 0; i < units.size(); ++i) {
      see_link(units[i]);
      sound = sound && !(units[i].result.last_dc_voltage > highest[i]);
    }
    sound = lineup.step(static_cast<std::size_t>(period)) && sound;
    std::size_t first = 0;
    for (const LinkedAxes& unit : units) {
      unit.link->step(kControlPeriod, lineup.drawn(first, unit.axes.size()));
      first += unit.axes.size();
    }
  }
  lineup.leave();
  for (LinkedAxes& unit : units) unit.result.periods = period;
  return period;
}

RunResult run(std::span<const AxisRun> axes, DcLink& link, long periods, double overvoltage,
              const LaneVariant& variant) noexcept {
  LinkedAxes unit{axes, &link, overvoltage};
  run_together({&unit, 1}, periods, variant);
  return unit.result;
}

}  // namespace motor
