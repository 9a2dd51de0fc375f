#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace motor {

/// Standard acceleration of gravity (m/s²).
inline constexpr double kGravity = 9.80665;

/// Elastic coupling between rotor and load, seen from the rotor.
struct Coupling {
  double stiffness = 0.0;  ///< (N·m/rad); 0 = rigid, rotor and load are one mass
  double damping = 0.0;    ///< (N·m·s/rad), not negative
  double backlash = 0.0;   ///< play between its two flanks (rad), not negative
};

/// Walls that the load runs against: spring and damper, in angles of the load from its place at power-on.
struct EndStops {
  double lower = -std::numeric_limits<double>::infinity();  ///< (rad), not positive
  double upper = std::numeric_limits<double>::infinity();   ///< (rad), not negative
  double stiffness = 1e4;                                   ///< (N·m/rad), positive
  double damping = 1.0;                                     ///< (N·m·s/rad), not negative
};

/// Holding brake on the motor shaft, closed without current.
struct HoldingBrake {
  double torque = 0.0;         ///< what it holds (N·m); 0 = no brake
  double opening_time = 0.1;   ///< p1216 (s)
  double closing_time = 0.05;  ///< p1217 (s)
};

/// Load torque over time: straight lines between points, the last one holds on or the first follows again.
struct TorqueProfile {
  static constexpr std::size_t kCapacity = 64;
  struct Point {
    double time = 0.0;    ///< since power-on (s), ascending
    double torque = 0.0;  ///< (N·m), positive against positive rotation
  };
  std::array<Point, kCapacity> points{};
  std::size_t count = 0;
  bool repeats = false;  ///< from the last point back to the first, which must have time 0
};

/// What hangs on the shaft. Torques, inertias and angles are those at the motor shaft (a gear is already
/// in them); external torques are positive when they act against positive rotation.
struct Load {
  double inertia = 0.0;           ///< (kg·m²); behind a coupling it must be positive
  double coulomb_friction = 0.0;  ///< (N·m)
  double viscous_friction = 0.0;  ///< (N·m·s/rad)
  double breakaway_torque = 0.0;  ///< static friction (N·m), counts above coulomb_friction (Stribeck)
  double stribeck_speed = 1.0;    ///< at which it has fallen to 1/e of its excess (rad/s), positive
  double constant_torque = 0.0;   ///< same sign whatever the speed: a weight, a tension, a second machine (N·m)
  double friction_torque = 0.0;   ///< dry friction beside coulomb_friction: a brake, a tool that cuts (N·m)
  double fan_coefficient = 0.0;   ///< torque k·w·|w| against the motion (N·m·s²/rad²), not negative
  double pendulum_torque = 0.0;   ///< weight on an arm: torque·sin(angle of the load), 0 = hanging down (N·m)
  TorqueProfile profile{};        ///< added to the others
  Coupling coupling{};
  EndStops end_stops{};
  HoldingBrake brake{};
};

/// What of machine and load can become different while they turn; angles and speeds go on as they are.
struct PlantSettings {
  double load_inertia = 0.0;      ///< (kg·m²); behind a coupling positive
  double coulomb_friction = 0.0;  ///< of the load (N·m), not negative
  double viscous_friction = 0.0;  ///< of the load (N·m·s/rad), not negative
  double ambient = 20.0;          ///< of the motor (°C)

  friend bool operator==(const PlantSettings&, const PlantSettings&) = default;
};

/// What a load torque that is set from outside does.
enum class LoadTorqueType : std::uint8_t {
  Constant,  ///< keeps its sign: drives a shaft that turns the other way, and one that stands
  Friction,  ///< acts against the motion, and holds a shaft that stands
};

/// Whether rotor and load are two masses.
constexpr bool is_elastic(const Load& load) noexcept {
  return load.coupling.stiffness > 0.0 && load.inertia > 0.0;
}

/// Constant torque of a hoist (N·m): @p mass (kg) on a rope over a drum of @p radius (m); lifting turns positive.
constexpr double hoist_torque(double mass, double radius) noexcept {
  return mass * kGravity * radius;
}

}  // namespace motor
