#include "cia402/motion/jerk_ramp.hpp"

#include <algorithm>
#include <cmath>

namespace cia402 {

JerkState after(const JerkState& from, double jerk, double time) noexcept {
  return {.way = from.way + time * (from.velocity + time * (from.acceleration / 2.0 + time * jerk / 6.0)),
          .velocity = from.velocity + time * (from.acceleration + time * jerk / 2.0),
          .acceleration = from.acceleration + time * jerk};
}

double velocity_without_acceleration(const JerkState& from, double jerk) noexcept {
  return from.velocity + from.acceleration * std::abs(from.acceleration) / (2.0 * jerk);
}

JerkRamp ramp_to(const JerkState& from, double velocity, const JerkLimits& limits) noexcept {
  const double jerk = limits.jerk;
  const bool rises = velocity >= velocity_without_acceleration(from, jerk);
  const double sign = rises ? 1.0 : -1.0;
  const double highest = rises ? limits.acceleration : limits.deceleration;
  const double start = sign * from.acceleration;
  const double rise = sign * (velocity - from.velocity);
  const double peak = std::sqrt(std::max(0.0, jerk * rise + start * start / 2.0));
  if (peak <= highest)
    return {JerkSegment{std::max(0.0, peak - start) / jerk, sign * jerk}, JerkSegment{},
            JerkSegment{peak / jerk, -sign * jerk}};
  // What building up and taking back leave of the difference is for the time at the limit.
  const double build_up = (highest - start) / jerk;
  const double changed = 0.5 * std::abs(build_up) * (highest + start) + 0.5 * highest * highest / jerk;
  return {JerkSegment{std::abs(build_up), build_up < 0.0 ? -sign * jerk : sign * jerk},
          JerkSegment{std::max(0.0, rise - changed) / highest, 0.0}, JerkSegment{highest / jerk, -sign * jerk}};
}

double end_of_ramp(const JerkState& from, double velocity, const JerkLimits& limits) noexcept {
  JerkState state = from;
  for (const JerkSegment& segment : ramp_to(from, velocity, limits)) state = after(state, segment);
  return state.way;
}

}  // namespace cia402
