#include "cia402/motion/jerk_profile.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {
namespace {

/// By how much rounding may make a way too short (position units, and as a share of it).
constexpr double kSamePlace = 1e-6;
constexpr double kSameShare = 1e-10;
/// Two velocities are one (as a share of what was decelerated).
constexpr double kSameVelocity = 1e-6;

constexpr double kLeast = 1e-3;
constexpr double kMost = 1e15;

double sound(double limit) noexcept {
  return limit > kLeast ? std::min(limit, kMost) : kLeast;
}

ProfileLimits sound(const ProfileLimits& limits) noexcept {
  return {limits.velocity > 0.0 ? std::min(limits.velocity, kMost) : 0.0, sound(limits.acceleration),
          sound(limits.deceleration), sound(limits.jerk)};
}

bool moves(const JerkState& state) noexcept {
  return std::abs(state.velocity) > 0.0 || std::abs(state.acceleration) > 0.0;
}

/// The number between 0 and @p most from which on @p exceeds is true.
template <class Condition>
double first_excess(double most, const Condition& exceeds) noexcept {
  constexpr int kHalvings = 100;  // more than a number has digits
  double least = 0.0;
  for (int i = 0; i < kHalvings && least < most; ++i) {
    const double middle = 0.5 * (least + most);
    (exceeds(middle) ? most : least) = middle;
  }
  return most;
}

}  // namespace

JerkState JerkProfile::state() const noexcept {
  if (index_ >= count_) return begin_;
  return after(begin_, segments_[index_].jerk, elapsed_);
}

void JerkProfile::place(double position, double velocity, double acceleration) noexcept {
  origin_ = target_ = position;
  direction_ = 1.0;
  limits_ = {};
  begin({0.0, velocity, acceleration}, moves({0.0, velocity, acceleration}) ? Phase::Placed : Phase::Holding);
}

void JerkProfile::move_to(double target, const ProfileLimits& limits, double passing_velocity) noexcept {
  if (!std::isfinite(target)) return;
  const ProfileLimits before = limits_;
  limits_ = next_limits_ = sound(limits);
  target_ = target;
  passing_velocity_ = passing_velocity;
  if (exceeds_velocity()) limits_.jerk = std::max(limits_.jerk, before.jerk);
  if (!can_reach()) keep_larger(before);
  plan();
}

void JerkProfile::keep_larger(const ProfileLimits& before) noexcept {
  limits_.deceleration = std::max(limits_.deceleration, before.deceleration);
  limits_.jerk = std::max(limits_.jerk, before.jerk);
}

/// Of the motion, or, at rest, of the way to the target; 0 where there is nothing to do.
double JerkProfile::heading() const noexcept {
  const double way = target_ - position();
  const double speed = velocity();
  const double of = std::abs(speed) > 0.0 ? speed : moves(state()) ? acceleration() : way;
  return std::abs(of) > 0.0 ? std::copysign(1.0, of) : 0.0;
}

/// At the target; 0 unless it leads beyond it in the direction of the way.
double JerkProfile::passing_speed() const noexcept {
  const double along = passing_velocity_ * heading();
  const bool leads_on = along > 0.0 && (target_ - position()) * heading() > 0.0;
  return leads_on ? std::min(along, limits_.velocity) : 0.0;
}

/// Whether the acceleration leads beyond the highest velocity before it is taken back.
bool JerkProfile::exceeds_velocity() const noexcept {
  const JerkState present = state();
  if (!(present.velocity * present.acceleration > 0.0)) return false;
  return std::abs(velocity_without_acceleration(present, limits_.jerk)) > limits_.velocity * (1.0 + kSameVelocity);
}

/// Whether the motion gets to its target without turning back.
bool JerkProfile::can_reach() const noexcept {
  const double sign = heading();
  const JerkState from{0.0, sign * velocity(), sign * acceleration()};
  if (!moves(from)) return true;
  const double slack = kSameVelocity * from.acceleration * from.acceleration / (2.0 * limits_.jerk);
  if (velocity_without_acceleration(from, limits_.jerk) < -slack) return false;
  if (passing_speed() > 0.0) return true;
  const double ahead = sign * (target_ - position());
  const double end = end_of_ramp(from, 0.0, jerk_limits());
  return ahead >= end - kSamePlace - kSameShare * (std::abs(end) + std::abs(origin_));
}

/// What to do from the present motion.
void JerkProfile::plan() noexcept {
  const double sign = heading();
  const double ahead = sign * (target_ - position());
  const JerkState from{0.0, sign * velocity(), sign * acceleration()};
  const bool reaches = can_reach();
  const double passing = passing_speed();
  origin_ = position();
  direction_ = sign < 0.0 ? -1.0 : 1.0;
  if (sign == 0.0) {
    passing_velocity_ = 0.0;
    return begin({}, Phase::Going);
  }
  if (!(limits_.velocity > 0.0)) return plan_stop(from, Phase::Pausing);
  if (!reaches) return plan_stop(from, Phase::Stopping);
  passing_velocity_ = sign * passing;
  plan_way(from, ahead);
}

void JerkProfile::plan_stop(const JerkState& from, Phase phase) noexcept {
  begin(from, phase);
  append(ramp_to(from, 0.0, jerk_limits()));
}

/// Towards the highest velocity as long as the ramp to the velocity at the target, shortest as it is, ends in
/// front of the target that lies @p ahead; then that ramp.
void JerkProfile::plan_way(const JerkState& from, double ahead) noexcept {
  const JerkLimits limits = jerk_limits();
  const double end = std::abs(passing_velocity_);
  begin(from, Phase::Going);
  if (end > 0.0 && end_of_ramp(from, end, limits) > ahead) return plan_short_pass(from, ahead);
  JerkState at = from;
  for (const JerkSegment& segment : ramp_to(from, limits_.velocity, limits)) {
    const auto is_late = [&](double time) {
      return end_of_ramp(after(at, segment.jerk, time), end, limits) >= ahead;
    };
    if (segment.duration > 0.0 && is_late(segment.duration)) {
      const JerkSegment part{first_excess(segment.duration, is_late), segment.jerk};
      append(part);
      return append(ramp_to(after(at, part), end, limits));
    }
    append(segment);
    at = after(at, segment);
  }
  at = {at.way, limits_.velocity, 0.0};
  append(JerkSegment{std::max(0.0, ahead - end_of_ramp(at, end, limits)) / limits_.velocity, 0.0});
  append(ramp_to(at, end, limits));
}

/// The target is passed before the motion has the velocity for it: with less, without acceleration; or, where it
/// cannot slow down in time, on the way to it.
void JerkProfile::plan_short_pass(const JerkState& from, double ahead) noexcept {
  const JerkLimits limits = jerk_limits();
  const double end = std::abs(passing_velocity_);
  const double least = velocity_without_acceleration(from, limits.jerk);
  if (least < end && end_of_ramp(from, least, limits) <= ahead) {
    const double more =
        first_excess(end - least, [&](double over) { return end_of_ramp(from, least + over, limits) >= ahead; });
    return append(ramp_to(from, least + more, limits));
  }
  append(ramp_to(from, end, limits));
  cut_at(ahead);
}

void JerkProfile::begin(const JerkState& from, Phase phase) noexcept {
  begin_ = from;
  phase_ = phase;
  count_ = index_ = 0;
  elapsed_ = 0.0;
}

void JerkProfile::append(const JerkSegment& segment) noexcept {
  if (count_ < kMostSegments) segments_[count_++] = segment;
}

void JerkProfile::append(const JerkRamp& ramp) noexcept {
  for (const JerkSegment& segment : ramp) append(segment);
}

/// The plan ends where its way is @p ahead.
void JerkProfile::cut_at(double ahead) noexcept {
  JerkState at = begin_;
  for (std::size_t i = 0; i < count_; ++i) {
    JerkSegment& segment = segments_[i];
    const auto is_late = [&](double time) { return after(at, segment.jerk, time).way >= ahead; };
    if (is_late(segment.duration)) {
      segment.duration = first_excess(segment.duration, is_late);
      count_ = i + 1;
      return;
    }
    at = after(at, segment);
  }
}

void JerkProfile::next_segment() noexcept {
  begin_ = after(begin_, segments_[index_]);
  elapsed_ = 0.0;
  ++index_;
}

/// Goes on for @p time (s) within the plan; what is left of it at the end of the plan.
double JerkProfile::run(double time) noexcept {
  while (index_ < count_) {
    const double rest = segments_[index_].duration - elapsed_;
    if (rest > time) {
      elapsed_ += time;
      return 0.0;
    }
    time -= rest;
    next_segment();
  }
  return time;
}

ProfileAdvance JerkProfile::advance(double dt) noexcept {
  double left = dt;
  while (!stands()) {
    left = run(left);
    if (index_ < count_) return {};
    const ProfileEvent event = finish();
    if (event != ProfileEvent::None) return {left, event};
  }
  return {};
}

/// The segments are at their end.
ProfileEvent JerkProfile::finish() noexcept {
  switch (phase_) {
    case Phase::Going:
      return std::abs(passing_velocity_) > 0.0 ? pass() : arrive();
    case Phase::Pausing:
      begin({begin_.way, 0.0, 0.0}, Phase::Holding);
      break;
    case Phase::Stopping:
      begin({begin_.way, 0.0, 0.0}, Phase::Holding);
      limits_ = next_limits_;
      plan();
      break;
    default:  // nobody has said where to go on
      passing_velocity_ = 0.0;
      plan();
  }
  return ProfileEvent::None;
}

ProfileEvent JerkProfile::arrive() noexcept {
  origin_ = target_;
  begin({}, Phase::Arrived);
  return ProfileEvent::Arrived;
}

ProfileEvent JerkProfile::pass() noexcept {
  origin_ = target_;
  begin({0.0, begin_.velocity, begin_.acceleration}, Phase::Placed);
  return ProfileEvent::Passed;
}

}  // namespace cia402
