// What bounds the motions of the basic positioner, and what it watches.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drive/positioning/positioner/positioner.hpp"

namespace drive {
namespace {

using enum PositioningMessage;

constexpr double kLongestJerkTime = 1.0;     // s
constexpr double kHighestOverride = 1.9999;  // 7FFFh of 4000h
constexpr double kTwoPi = 2.0 * std::numbers::pi;

}  // namespace

/// p2577 is taken over with the pulses off.
void Positioner::follow_modulo(const PositionerSlice& slice) noexcept {
  if (!slice.is_ready_to_switch_on) return;
  const double range = inputs.modulo ? settings.modulo_range : 0.0;
  blocks_changed_ = blocks_changed_ || range != modulo_range_;
  modulo_range_ = range;
}

bool Positioner::has_software_limits() const noexcept {
  return inputs.software_limits && reference_.is_set && !(modulo_range_ > 0.0);
}

void Positioner::bound(const PositionerSlice& slice) noexcept {
  TravelConditions conditions{.acceleration = settings.maximum_acceleration,
                              .deceleration = settings.maximum_deceleration,
                              .velocity_override = std::clamp(inputs.velocity_override, 0.0, kHighestOverride)};
  const double of_modulo = modulo_range_ > 0.0 ? modulo_range_ / 2.0 / kSlice : kEndless;
  messages_.show(MaximumVelocityLimited, settings.maximum_velocity > of_modulo);
  const double of_motor = slice.highest_speed * std::abs(inputs.units_per_revolution) / kTwoPi;
  conditions.velocity = std::min({settings.maximum_velocity, of_modulo, of_motor});
  const auto external = [](double given) { return given > 0.0 ? given : kEndless; };
  conditions.velocity = std::min(conditions.velocity, external(inputs.external_velocity[0]));
  conditions.directed_velocity = {external(inputs.external_velocity[1]), external(inputs.external_velocity[2])};
  if (!(modulo_range_ > 0.0)) {
    conditions.lower = kLowestPosition;
    conditions.upper = kHighestPosition;
  }
  if (has_software_limits()) {
    conditions.lower = std::max(conditions.lower, inputs.software_limit_minus);
    conditions.upper = std::min(conditions.upper, inputs.software_limit_plus);
  }
  for (const Direction direction : {Direction::Positive, Direction::Negative})
    conditions.barred[place_of(direction)] = stop_cams_.bars(direction);
  if (conditions != travel_.conditions()) travel_.bound(conditions);
}

/// Tr = max(p2572, p2573) / p2574, 1 s at the most (A07440).
void Positioner::limit_jerk() noexcept {
  const double time = std::max(settings.maximum_acceleration, settings.maximum_deceleration) / settings.jerk;
  messages_.show(JerkTimeLimited, time > kLongestJerkTime);
  const bool limits = inputs.limits_jerk || blocks_.limits_jerk();
  travel_.limit_jerk(limits ? std::min(time, kLongestJerkTime) : 0.0);
}

/// The table of blocks is checked when it or what it is checked against has changed.
void Positioner::follow_blocks() noexcept {
  const bool limited = inputs.software_limits && !(modulo_range_ > 0.0);
  const BlockLimits limits{.lower = limited ? inputs.software_limit_minus : -kEndless,
                           .upper = limited ? inputs.software_limit_plus : kEndless,
                           .modulo_range = modulo_range_};
  if (!blocks_changed_ && limits == block_limits_) return;
  blocks_changed_ = false;
  block_limits_ = limits;
  blocks_.limit(limits);
  check_blocks(BlockTable{settings}, limits, messages_);
}

/// The setpoint at a limit, and targets beyond it.
void Positioner::watch_limits() noexcept {
  const bool software = has_software_limits();
  const bool still = travel_.is_still() && !tracks_ && !(modulo_range_ > 0.0);
  const double place = travel_.position();
  const bool minus = still && software && place <= inputs.software_limit_minus;
  const bool plus = still && software && place >= inputs.software_limit_plus;
  messages_.show(LimitMinusReached, minus);
  messages_.show(LimitPlusReached, plus);
  messages_.show(BeginningOfRange, still && !minus && place <= kLowestPosition);
  messages_.show(EndOfRange, still && !plus && place >= kHighestPosition);
  messages_.show(VelocityLimited, travel_.is_capped());
  const bool aims = software && has_task() && !tracks_ && travel_.is_cut_off() && travel_.has_target();
  messages_.show(TargetBelowLimit, aims && travel_.goal().target < inputs.software_limit_minus);
  messages_.show(TargetAboveLimit, aims && travel_.goal().target > inputs.software_limit_plus);
}

/// Beyond a software limit and not on the way back; within the positioning window it is overshoot.
void Positioner::watch_actual_position(const PositionerSlice& slice) noexcept {
  const bool active = has_software_limits() && inputs.position_valid;
  const double actual = sets_actual_ ? travel_.position() : inputs.actual_position + actual_moved_by_;
  const auto watch = [&](Direction direction, double beyond, PositioningMessage message) {
    bool& reported = beyond_reported_[place_of(direction)];
    const bool outside = active && beyond > slice.positioning_window;
    const bool returns = travel_.velocity() * sign_of(direction) < 0.0;
    if (!outside) reported = false;
    if (!outside || returns || reported) return;
    reported = true;
    messages_.raise(message);
  };
  watch(Direction::Negative, inputs.software_limit_minus - actual, BelowLimitMinus);
  watch(Direction::Positive, actual - inputs.software_limit_plus, AboveLimitPlus);
}

}  // namespace drive
