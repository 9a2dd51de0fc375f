#pragma once

#include <cmath>

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"

namespace motor {

/// exp(-y) for y from 0 to 9, 1e-4 of the result or better, without the mathematical library.
constexpr double decay(double y) noexcept {
  const double z = y * (1.0 / 64.0);
  double power = 1.0 / (1.0 + z * (1.0 + z * (0.5 + z * (1.0 / 6.0))));
  for (int i = 0; i < 6; ++i) power *= power;
  return power;
}

/// Dry friction of one mass: constant while it turns, more when it must break away (Stribeck).
struct DryFriction {
  double coulomb = 0.0;         ///< (N·m)
  double excess = 0.0;          ///< of the static friction above it (N·m)
  double stribeck_speed = 1.0;  ///< at which the excess has fallen to 1/e (rad/s), positive

  /// What holds at standstill (N·m).
  double holding() const noexcept { return coulomb + excess; }
  /// What brakes at @p speed (rad/s).
  double at(double speed) const noexcept {
    if (excess <= 0.0 || std::abs(speed) >= 3.0 * stribeck_speed) return coulomb;
    const double ratio = speed / stribeck_speed;
    return coulomb + excess * decay(ratio * ratio);
  }
};

/// Dry friction of @p load alone.
constexpr DryFriction load_friction(const Load& load) noexcept {
  const double excess = load.breakaway_torque - load.coulomb_friction;
  return {load.coulomb_friction, excess > 0.0 ? excess : 0.0, load.stribeck_speed};
}
/// @p friction and that of the bearings of @p machine, for one mass.
constexpr DryFriction with_bearings(DryFriction friction, const MachineData& machine) noexcept {
  friction.coulomb += machine.coulomb_friction;
  return friction;
}

/// How one mass meets its dry friction in a step: decided at the start, while the step the torque is constant.
struct Grip {
  bool stuck = false;
  double torque = 0.0;     ///< against positive rotation (N·m)
  double direction = 0.0;  ///< of the motion, -1, 0 or 1

  /// For a mass at @p speed (rad/s) that @p driving (N·m) pulls forward. @p drag is dry as well, but not of @p
  /// friction.
  static Grip decide(const DryFriction& friction, double drag, double speed, double driving) noexcept {
    const double holds = friction.holding() + drag;
    if (holds <= 0.0) return {};
    const bool stands = speed == 0.0;
    if (stands && std::abs(driving) <= holds) return {true, 0.0, 0.0};
    const double reference = stands ? driving : speed;
    const double direction = reference > 0.0 ? 1.0 : -1.0;
    return {false, direction * (friction.at(speed) + drag), direction};
  }
};

/// How a mass has moved in a step.
struct Motion {
  double speed = 0.0;  ///< at its end (rad/s)
  double angle = 0.0;  ///< (rad)
  double path = 0.0;   ///< the angle without its sign (rad)
};

/// Speed below which a mass is taken for standing, or the last trace of a decay would never end (rad/s).
inline constexpr double kRestSpeed = 1e-9;

/// The end of a step of @p h (s) from @p speed to @p moved, made with @p grip throughout, in which the speed has
/// changed its sign: the mass stops there if the rest of the torque cannot overcome the friction, or goes on with
/// the friction reversed. @p inverse_inertia in 1/(kg·m²).
Motion reversed(const Grip& grip, double speed, const Motion& moved, double inverse_inertia, double h) noexcept;

/// The end of any step, as reversed() where the speed has changed its sign against the friction.
[[gnu::always_inline]] inline Motion settled(const Grip& grip, double speed, const Motion& moved,
                                             double inverse_inertia, double h) noexcept {
  if (moved.speed * grip.direction < 0.0) [[unlikely]]
    return reversed(grip, speed, moved, inverse_inertia, h);
  return {std::abs(moved.speed) < kRestSpeed ? 0.0 : moved.speed, moved.angle, moved.path};
}

}  // namespace motor
