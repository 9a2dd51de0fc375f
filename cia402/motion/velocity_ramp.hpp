#pragma once

namespace cia402 {

/// Slopes of a velocity demand (position units/s²), positive.
struct VelocitySlopes {
  double acceleration = 1.0;  ///< away from standstill
  double deceleration = 1.0;  ///< towards it

  friend bool operator==(const VelocitySlopes&, const VelocitySlopes&) = default;
};

/// @p velocity after @p dt (s) on its way to @p target, which it does not overshoot; through standstill the slope
/// changes where it falls.
double ramped(double velocity, double target, const VelocitySlopes& slopes, double dt) noexcept;

}  // namespace cia402
