#include "cia402/motion/position_profile.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {

void PositionProfile::place(double position, double velocity) noexcept {
  trapezoid_.place(position, velocity);
  is_jerk_limited_ = false;
  passing_direction_ = 0.0;
}

void PositionProfile::use_trapezoid() noexcept {
  if (is_jerk_limited_) place(jerk_.position(), jerk_.velocity());
}

/// The acceleration of a trapezoid may jump: it is taken over as far as the jerk can take it back in time.
void PositionProfile::use_jerk(double target, const ProfileLimits& limits) noexcept {
  if (is_jerk_limited_) return;
  is_jerk_limited_ = true;
  const double velocity = trapezoid_.velocity();
  const double speed = std::abs(velocity);
  const double direction = std::copysign(1.0, velocity);
  const double least = -std::sqrt(2.0 * limits.jerk * speed);
  const double most = std::sqrt(2.0 * limits.jerk * std::max(0.0, limits.velocity - speed));
  const double along = speed > 0.0 ? std::clamp(direction * trapezoid_.acceleration(), least, most) : 0.0;
  jerk_.place(trapezoid_.position(), velocity, direction * along);
  if (along > 0.0 && stopping_way(limits) > direction * (target - position()))
    jerk_.place(trapezoid_.position(), velocity, 0.0);
}

void PositionProfile::move_to(double target, const ProfileLimits& limits, double passing_velocity) noexcept {
  if (limits.jerk > 0.0) {
    use_jerk(target, limits);
    return jerk_.move_to(target, limits, passing_velocity);
  }
  use_trapezoid();
  move_trapezoid(target, limits, passing_velocity);
}

/// With a velocity at its target a trapezoid leads to where it would come to rest behind it.
void PositionProfile::move_trapezoid(double target, const ProfileLimits& limits,
                                     double passing_velocity) noexcept {
  const double passing = std::min(std::abs(passing_velocity), limits.velocity);
  const double direction = std::copysign(1.0, passing_velocity);
  const bool passes = passing > 0.0 && (target - position()) * direction > 0.0;
  passing_direction_ = passes ? direction : 0.0;
  passed_target_ = target;
  const double beyond = passes ? 0.5 * passing * passing / limits.deceleration : 0.0;
  constexpr bool kKeepsLargerDeceleration = true;
  trapezoid_.move_to(target + direction * beyond, {limits.velocity, limits.acceleration, limits.deceleration},
                     kKeepsLargerDeceleration);
}

void PositionProfile::brake(double deceleration) noexcept {
  use_trapezoid();
  passing_direction_ = 0.0;
  trapezoid_.brake(deceleration);
}

double PositionProfile::stopping_way(const ProfileLimits& limits) const noexcept {
  const double speed = std::abs(velocity());
  if (!(speed > 0.0)) return 0.0;
  if (!(limits.jerk > 0.0)) return 0.5 * speed * speed / limits.deceleration;
  const double along = std::copysign(1.0, velocity()) * (is_jerk_limited_ ? acceleration() : 0.0);
  return end_of_ramp({0.0, speed, along}, 0.0, {limits.acceleration, limits.deceleration, limits.jerk});
}

ProfileAdvance PositionProfile::advance(double dt) noexcept {
  if (is_jerk_limited_) return jerk_.advance(dt);
  if (std::abs(passing_direction_) > 0.0) return pass_within(dt);
  return advance_trapezoid(dt);
}

ProfileAdvance PositionProfile::advance_trapezoid(double dt) noexcept {
  const auto advance = trapezoid_.advance(dt, false, true);
  const bool arrived = advance.event == drive::TrapezoidProfile::Event::Standstill && has_arrived();
  return {advance.left, arrived ? ProfileEvent::Arrived : ProfileEvent::None};
}

/// Goes on for @p dt, or to the instant at which the target is passed.
ProfileAdvance PositionProfile::pass_within(double dt) noexcept {
  const auto passes_after = [this](double time) {
    drive::TrapezoidProfile ahead = trapezoid_;
    ahead.advance(time);
    return is_past(ahead);
  };
  if (!passes_after(dt)) return advance_trapezoid(dt);
  constexpr int kHalvings = 60;  // of a cycle: more than a number has digits
  double least = 0.0;
  double most = dt;
  for (int i = 0; i < kHalvings && least < most; ++i) {
    const double middle = 0.5 * (least + most);
    (passes_after(middle) ? most : least) = middle;
  }
  trapezoid_.advance(most);
  trapezoid_.shift(passed_target_ - trapezoid_.position());
  passing_direction_ = 0.0;
  return {dt - most, ProfileEvent::Passed};
}

double highest_velocity_before(double way, const ProfileLimits& limits) noexcept {
  if (!(way > 0.0)) return 0.0;
  const double deceleration = limits.deceleration;
  if (!(limits.jerk > 0.0)) return std::sqrt(2.0 * deceleration * way);
  const double without_limit = std::cbrt(way * way * limits.jerk);
  if (std::sqrt(without_limit * limits.jerk) <= deceleration) return without_limit;
  const double lost = 0.5 * deceleration * deceleration / limits.jerk;
  return std::sqrt(lost * lost + 2.0 * deceleration * way) - lost;
}

}  // namespace cia402
