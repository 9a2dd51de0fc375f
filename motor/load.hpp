#pragma once

namespace motor {

/// What hangs on the shaft. External torques are positive when they act against positive rotation.
struct Load {
  double inertia = 0.0;           ///< rigidly coupled (kg·m²)
  double coulomb_friction = 0.0;  ///< (N·m)
  double viscous_friction = 0.0;  ///< (N·m·s/rad)
  double constant_torque = 0.0;   ///< same sign whatever the speed: a weight, a tension, a second machine (N·m)
  double fan_coefficient = 0.0;   ///< torque k·w·|w| against the motion (N·m·s²/rad²), not negative
};

/// Constant torque of a hoist (N·m): @p mass (kg) on a rope over a drum of @p radius (m); lifting turns positive.
constexpr double hoist_torque(double mass, double radius) noexcept {
  constexpr double kGravity = 9.80665;
  return mass * kGravity * radius;
}

}  // namespace motor
