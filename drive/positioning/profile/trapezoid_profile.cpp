#include "drive/positioning/profile/trapezoid_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drive {
namespace {

/// Two places are one (LU), and two ways of the same length (as a share of it): what rounding may make of them.
constexpr double kSamePlace = 1e-9;
constexpr double kSameShare = 1e-11;
/// A deceleration may differ so much (as a share) for the braking to end exactly at its target.
constexpr double kSameDeceleration = 1e-6;
/// What is nearer than this (s) is at the same instant.
constexpr double kInstant = 1e-12;
/// The position is taken apart anew beyond this way from its origin (LU).
constexpr double kFar = 1024.0;

constexpr double kLeastAcceleration = 1e-3;  // LU/s²
constexpr double kMost = 1e15;               // LU/s, LU/s²

/// @p limit if it is a number that can be computed with.
double sound_acceleration(double limit) noexcept {
  return limit > kLeastAcceleration ? std::min(limit, kMost) : kLeastAcceleration;
}

MotionLimits sound(const MotionLimits& limits) noexcept {
  return {limits.velocity > 0.0 ? std::min(limits.velocity, kMost) : 0.0, sound_acceleration(limits.acceleration),
          sound_acceleration(limits.deceleration)};
}

/// How far braking ends short of (negative) or beyond the target so that it still counts as exact (LU).
double tolerance(double distance) noexcept {
  return kSamePlace + kSameShare * distance;
}

}  // namespace

void TrapezoidProfile::place(double position) noexcept {
  origin_ = std::nearbyint(position);
  local_ = position - origin_;
  target_ = position;
  stretch_ = {};
  rest(Phase::Idle);
}

void TrapezoidProfile::place(double position, double velocity) noexcept {
  place(position);
  limits_ = {};
  if (!(std::abs(velocity) > 0.0)) return;
  velocity_ = velocity;
  target_ = std::copysign(std::numeric_limits<double>::infinity(), velocity);
  braking_distance_ = 0.0;
  start(Phase::Cruising, 0.0, 0.0);
}

void TrapezoidProfile::move_to(double target, const MotionLimits& limits,
                               bool keeps_larger_deceleration) noexcept {
  const double before = limits_.deceleration;
  limits_ = sound(limits);
  if (std::isnan(target)) return stop(Phase::Stopping);
  next_deceleration_ = limits_.deceleration;
  if (keeps_larger_deceleration && !can_reach(target, limits_.deceleration))
    limits_.deceleration = std::max(limits_.deceleration, before);
  target_ = target;
  plan();
}

void TrapezoidProfile::brake(double deceleration) noexcept {
  limits_.deceleration = sound_acceleration(deceleration);
  if (!(std::abs(velocity_) > 0.0)) {
    target_ = position();
    return rest(Phase::Idle);
  }
  stop(Phase::Stopping);
}

void TrapezoidProfile::shift(double by) noexcept {
  const double whole = std::nearbyint(by);
  const double part = by - whole;
  origin_ += whole;
  local_ += part;
  end_local_ += part;
  target_ += by;
}

bool TrapezoidProfile::can_reach(double target, double deceleration) const noexcept {
  const double distance = braking_distance(sound_acceleration(deceleration));
  return !(std::abs(velocity_) > 0.0) || direction() * way_to(target) >= distance - tolerance(distance);
}

/// Whether the deceleration leads from here to a place that lies @p ahead (LU).
bool TrapezoidProfile::is_at_braking_point(double ahead) const noexcept {
  const double distance = braking_distance(limits_.deceleration);
  return std::abs(distance - ahead) <= tolerance(distance);
}

/// What to do next, from the present position and velocity.
void TrapezoidProfile::plan() noexcept {
  rebase();
  const double way = way_to(target_);
  const bool moves = std::abs(velocity_) > 0.0;
  const double heading = moves ? direction() : std::copysign(1.0, way);
  const double ahead = heading * way;
  if (moves ? is_at_braking_point(ahead) : !(ahead > 0.0)) return brake_to_target();
  if (!(limits_.velocity > 0.0)) return moves ? stop(Phase::Pausing) : rest(Phase::Holding);
  if (ahead < braking_distance(limits_.deceleration)) return stop(Phase::Reversing);
  plan_ahead(heading, ahead);
}

/// To the velocity from which the deceleration leads to a target that lies @p ahead (LU) and can be reached.
void TrapezoidProfile::plan_ahead(double direction, double ahead) noexcept {
  const double a = limits_.acceleration;
  const double d = limits_.deceleration;
  const double speed = std::abs(velocity_);
  double peak = limits_.velocity;
  double slope = -d;
  if (speed <= peak) {
    const double room = std::max(0.0, ahead - braking_distance(d));
    peak = std::clamp(std::sqrt(speed * speed + 2.0 * room * (a * d / (a + d))), speed, peak);
    slope = a;
  }
  const double duration = (peak - speed) / slope;
  end_velocity_ = direction * peak;
  end_local_ = local_ + direction * 0.5 * (speed + peak) * duration;
  braking_distance_ = 0.5 * peak * peak / d;
  start(Phase::Ramping, direction * slope, duration);
}

/// To rest with the deceleration, wherever that is.
void TrapezoidProfile::stop(Phase phase) noexcept {
  rebase();
  const double duration = std::abs(velocity_) / limits_.deceleration;
  end_velocity_ = 0.0;
  end_local_ = local_ + 0.5 * velocity_ * duration;
  if (phase == Phase::Stopping) target_ = origin_ + end_local_;
  start(phase, -direction() * limits_.deceleration, duration);
}

/// To rest at the target, which the deceleration reaches but for rounding.
void TrapezoidProfile::brake_to_target() noexcept {
  rebase();
  const double speed = std::abs(velocity_);
  const double ahead = direction() * way_to(target_);
  double slope = limits_.deceleration;
  if (ahead > 0.0) {
    const double exact = 0.5 * speed * speed / ahead;
    if (std::abs(exact - slope) <= kSameDeceleration * slope) slope = exact;
  }
  end_velocity_ = 0.0;
  end_local_ = target_ - origin_;
  start(Phase::Braking, -direction() * slope, speed / slope);
  announces_ = true;
}

void TrapezoidProfile::start(Phase phase, double acceleration, double duration) noexcept {
  phase_ = phase;
  acceleration_ = duration > 0.0 ? acceleration : 0.0;
  rest_ = duration;
  rest_error_ = 0.0;
  announces_ = false;
}

TrapezoidProfile::Advance TrapezoidProfile::go_on(double dt, bool stops_at_braking_point,
                                                  bool stops_at_standstill) noexcept {
  double left = dt - debt_;
  debt_ = 0.0;
  const auto stop_at = [&](Event event) {
    debt_ = stands() ? 0.0 : std::max(0.0, -left);
    return Advance{std::max(0.0, left), event};
  };
  while (!stands()) {
    if (announces_) {
      announces_ = false;
      if (stops_at_braking_point) return stop_at(Event::BrakingPoint);
    }
    const double to_go = time_to_go();
    if (to_go > left + kInstant) {
      if (left > 0.0) move(left);
      debt_ = std::max(0.0, -left);
      return {};
    }
    left -= to_go;
    finish_phase(to_go);
    if (stands() && stops_at_standstill) return stop_at(Event::Standstill);
  }
  stretch_.area += stretch_.way * std::max(0.0, left);
  return {};
}

/// Until the phase ends (s).
double TrapezoidProfile::time_to_go() const noexcept {
  if (phase_ != Phase::Cruising) return rest_;
  const double speed = std::abs(velocity_);
  if (!(speed > 0.0)) return 0.0;
  return std::max(0.0, (direction() * way_to(target_) - braking_distance_) / speed);
}

void TrapezoidProfile::add_to_stretch(double time) noexcept {
  stretch_.area += time * (stretch_.way + time * (velocity_ / 2.0 + time * acceleration_ / 6.0));
  stretch_.way += time * (velocity_ + time * acceleration_ / 2.0);
}

/// Goes on within the phase. A ramp is followed from its end, so that it gets there without an error.
void TrapezoidProfile::move(double time) noexcept {
  add_to_stretch(time);
  if (phase_ == Phase::Cruising) {
    local_ += velocity_ * time;
    if (std::abs(local_) > kFar) rebase();
    return;
  }
  const double step = -time - rest_error_;  // compensated, for a long ramp has many cycles
  const double rest = rest_ + step;
  rest_error_ = (rest - rest_) - step;
  rest_ = rest;
  velocity_ = end_velocity_ - acceleration_ * rest_;
  local_ = end_local_ - rest_ * (end_velocity_ - 0.5 * acceleration_ * rest_);
}

/// To the end of the phase, which is @p time (s) away, and into the next one.
void TrapezoidProfile::finish_phase(double time) noexcept {
  add_to_stretch(time);
  if (phase_ == Phase::Cruising) {
    rebase();
    local_ = target_ - origin_ - direction() * braking_distance_;
    return brake_to_target();
  }
  local_ = end_local_;
  velocity_ = end_velocity_;
  switch (phase_) {
    case Phase::Stopping:
      return rest(Phase::Idle);
    case Phase::Pausing:
      return rest(Phase::Holding);
    case Phase::Reversing:
      limits_.deceleration = next_deceleration_;
      return plan();
    case Phase::Braking:
      return rest(Phase::Arrived);
    default:
      break;
  }
  rebase();
  start(Phase::Cruising, 0.0, 0.0);
}

void TrapezoidProfile::rest(Phase phase) noexcept {
  velocity_ = acceleration_ = 0.0;
  announces_ = false;
  debt_ = 0.0;
  phase_ = phase;
  if (phase != Phase::Arrived) return;
  origin_ = std::nearbyint(target_);
  local_ = target_ - origin_;
}

/// Brings the origin to the whole length unit that is nearest.
void TrapezoidProfile::rebase() noexcept {
  const double whole = std::nearbyint(local_);
  origin_ += whole;
  local_ -= whole;
  end_local_ -= whole;
}

}  // namespace drive
