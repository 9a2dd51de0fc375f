#pragma once

#include <array>

namespace cia402 {

/// What a jerk-limited motion in the positive direction may do (position units; s).
struct JerkLimits {
  double acceleration = 1.0;  ///< highest acceleration, positive
  double deceleration = 1.0;  ///< lowest acceleration, with a positive sign
  double jerk = 1.0;          ///< positive
};

/// Where a motion is, from where it began.
struct JerkState {
  double way = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};

/// A time of constant jerk.
struct JerkSegment {
  double duration = 0.0;  ///< s
  double jerk = 0.0;      ///< position units/s³
};

/// From one velocity to another: acceleration is built up, held, and taken back.
using JerkRamp = std::array<JerkSegment, 3>;

/// @p from after @p time (s) of @p jerk.
JerkState after(const JerkState& from, double jerk, double time) noexcept;
inline JerkState after(const JerkState& from, const JerkSegment& segment) noexcept {
  return after(from, segment.jerk, segment.duration);
}

/// The velocity at which the acceleration would be 0 if it were taken back from now on.
double velocity_without_acceleration(const JerkState& from, double jerk) noexcept;

/// The shortest ramp from @p from to @p velocity with acceleration 0. An acceleration beyond its limit is taken
/// back to it with the jerk.
JerkRamp ramp_to(const JerkState& from, double velocity, const JerkLimits& limits) noexcept;

/// Where that ramp ends, as a way from where @p from counts.
double end_of_ramp(const JerkState& from, double velocity, const JerkLimits& limits) noexcept;

}  // namespace cia402
