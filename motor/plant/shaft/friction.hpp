#pragma once

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/math/number.hpp"

namespace motor {

/// exp(-y) for y from 0 to 9, 1e-4 of the result or better, without the mathematical library.
template <class Number>
constexpr Number decay(const Number& y) noexcept {
  const Number z = y * (1.0 / 64.0);
  Number power = 1.0 / (1.0 + z * (1.0 + z * (0.5 + z * (1.0 / 6.0))));
  for (int i = 0; i < 6; ++i) power *= power;
  return power;
}

/// Dry friction of one mass: constant while it turns, more when it must break away (Stribeck).
template <class Number>
struct DryFrictionOf {
  Number coulomb = 0.0;         ///< (N·m)
  Number excess = 0.0;          ///< of the static friction above it (N·m)
  Number stribeck_speed = 1.0;  ///< at which the excess has fallen to 1/e (rad/s), positive

  /// What holds at standstill (N·m).
  Number holding() const noexcept { return coulomb + excess; }
  /// What brakes at @p speed (rad/s).
  Number at(const Number& speed) const noexcept {
    const Condition<Number> slow = !(excess <= 0.0 || abs(speed) >= 3.0 * stribeck_speed);
    if (!any(slow)) return coulomb;
    const Number ratio = speed / stribeck_speed;
    return select<Number>(slow, coulomb + excess * decay(Number{ratio * ratio}), coulomb);
  }
};
using DryFriction = DryFrictionOf<double>;

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
template <class Number>
struct GripOf {
  Flag<Number> stuck{};
  Number torque = 0.0;     ///< against positive rotation (N·m)
  Number direction = 0.0;  ///< of the motion, -1, 0 or 1

  /// For a mass at @p speed (rad/s) that @p driving (N·m) pulls forward. @p drag is dry as well, but not of @p
  /// friction.
  static GripOf decide(const DryFrictionOf<Number>& friction, const Number& drag, const Number& speed,
                       const Number& driving) noexcept {
    const Number holds = friction.holding() + drag;
    const Condition<Number> free = holds <= 0.0;
    if (all(free)) return {};
    const Condition<Number> stands = speed == 0.0;
    const Condition<Number> stuck = !free && stands && abs(driving) <= holds;
    const Condition<Number> none = free || stuck;
    if (all(none)) return {stuck, 0.0, 0.0};
    const Number reference = select<Number>(stands, driving, speed);
    const Number direction = select<Number>(reference > 0.0, 1.0, -1.0);
    return {stuck, select<Number>(none, 0.0, direction * (friction.at(speed) + drag)),
            select<Number>(none, 0.0, direction)};
  }
  friend GripOf select(const Condition<Number>& condition, const GripOf& a, const GripOf& b) noexcept {
    return {motor::select(condition, a.stuck, b.stuck), motor::select(condition, a.torque, b.torque),
            motor::select(condition, a.direction, b.direction)};
  }
};
using Grip = GripOf<double>;

/// How a mass has moved in a step.
template <class Number>
struct MotionOf {
  Number speed = 0.0;  ///< at its end (rad/s)
  Number angle = 0.0;  ///< (rad)
  Number path = 0.0;   ///< the angle without its sign (rad)

  friend MotionOf select(const Condition<Number>& condition, const MotionOf& a, const MotionOf& b) noexcept {
    return {motor::select(condition, a.speed, b.speed), motor::select(condition, a.angle, b.angle),
            motor::select(condition, a.path, b.path)};
  }
};
using Motion = MotionOf<double>;

/// Speed below which a mass is taken for standing, or the last trace of a decay would never end (rad/s).
inline constexpr double kRestSpeed = 1e-9;

/// The end of a step of @p h (s) from @p speed to @p moved, made with @p grip throughout, in which the speed has
/// changed its sign: the mass stops there if the rest of the torque cannot overcome the friction, or goes on with
/// the friction reversed. @p inverse_inertia in 1/(kg·m²).
template <class Number>
[[gnu::noinline]] MotionOf<Number> reversed(const GripOf<Number>& grip, const Number& speed,
                                            const MotionOf<Number>& moved, const Number& inverse_inertia,
                                            const Number& h) noexcept {
  const Number before = (moved.speed - speed) / h;
  const Number stops_after = -speed / before;
  const Number there = 0.5 * speed * stops_after;
  const Number after = before + 2.0 * grip.torque * inverse_inertia;
  const Number left = h - stops_after;
  const Number back = 0.5 * after * left * left;
  return select(after * grip.direction >= 0.0, MotionOf<Number>{0.0, there, abs(there)},
                MotionOf<Number>{after * left, there + back, abs(there) + abs(back)});
}

/// The end of any step, as reversed() where the speed has changed its sign against the friction.
template <class Number>
[[gnu::always_inline]] inline MotionOf<Number> settled(const GripOf<Number>& grip, const Number& speed,
                                                       const MotionOf<Number>& moved,
                                                       const Number& inverse_inertia, const Number& h) noexcept {
  const MotionOf<Number> rested{select<Number>(abs(moved.speed) < kRestSpeed, 0.0, moved.speed), moved.angle,
                                moved.path};
  const Condition<Number> turned_round = moved.speed * grip.direction < 0.0;
  if (any(turned_round)) [[unlikely]]
    return select(turned_round, reversed(grip, speed, moved, inverse_inertia, h), rested);
  return rested;
}

}  // namespace motor
