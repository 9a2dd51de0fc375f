#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "motor/data/load.hpp"
#include "motor/math/rotation.hpp"

namespace motor {

/// A line of torque over time: where it is when a step begins, and its slope.
template <class Number>
struct TorqueLineOf {
  Number torque = 0.0;  ///< (N·m)
  Number slope = 0.0;   ///< (N·m/s)
};
using TorqueLine = TorqueLineOf<double>;

/// Torque of a profile over time, walked through in steps of constant length.
class ProfileTorque {
 public:
  explicit ProfileTorque(const TorqueProfile& profile) noexcept : profile_{profile} {}

  bool present() const noexcept { return profile_.count > 0; }
  /// Whether it stays as it is from now on.
  bool over() const noexcept { return !present() || (next_ == profile_.count && !profile_.repeats); }
  /// The line that holds from @p time on (s since power-on, ascending from call to call); without a profile none.
  TorqueLine at(double time) noexcept { return present() ? line_at(time) : TorqueLine{}; }

 private:
  TorqueLine line_at(double time) noexcept;

  TorqueProfile profile_;
  std::size_t next_ = 0;  // first point that is still to come
  double lap_start_ = 0.0;
  std::int64_t laps_ = 0;
};

/// A profile for each lane, motor/lockstep.
template <class Number>
class LaneProfiles;

template <class Number>
using ProfileOf = std::conditional_t<std::is_same_v<Number, double>, ProfileTorque, LaneProfiles<Number>>;

/// All that hangs on a shaft, as one torque against positive rotation.
template <class Number>
class LoadTorqueOf {
 public:
  /// Of @p load, but for its profile.
  explicit LoadTorqueOf(const Load& load) noexcept
      : constant_{load.constant_torque}, fan_{load.fan_coefficient}, pendulum_{load.pendulum_torque} {}
  LoadTorqueOf() = default;

  void set_constant(double torque) noexcept { constant_ = torque; }
  /// Prepares a step on @p line of the profile that begins at the load angle @p angle (rad).
  void begin(const TorqueLineOf<Number>& line, const Number& angle) noexcept {
    line_ = line;
    turn_to(angle);
  }
  /// Puts the load at @p angle (rad) without any time passing.
  void turn_to(const Number& angle) noexcept {
    if (any(pendulum_ != 0.0)) direction_ = {cosine(angle), sine(angle)};
  }
  /// Constant part (N·m).
  Number constant() const noexcept { return constant_; }
  /// Torque (N·m) at @p speed (rad/s), @p angle (rad) and @p time (s) after the start of the step.
  Number at(const Number& speed, const Number& angle, const Number& time) const noexcept {
    const Number torque = constant_ + line_.torque + line_.slope * time + fan_ * speed * abs(speed);
    const Condition<Number> hangs = pendulum_ != 0.0;
    if (!any(hangs)) return torque;
    return select<Number>(hangs, torque + pendulum_ * (direction_ * vector(small_rotation(angle))).im, torque);
  }

 private:
  Number constant_ = 0.0;
  Number fan_ = 0.0;
  Number pendulum_ = 0.0;
  TorqueLineOf<Number> line_{};
  SpaceVectorOf<Number> direction_{1.0, 0.0};  // of the load
};
using LoadTorque = LoadTorqueOf<double>;

/// Walls that only push.
template <class Number>
class EndStopTorqueOf {
 public:
  /// What a wall does (N·m, against positive rotation): what its spring holds, and what acts on the load.
  struct Push {
    Number spring = 0.0;
    Number total = 0.0;
  };

  explicit EndStopTorqueOf(const EndStops& stops) noexcept
      : lower_{stops.lower},
        upper_{stops.upper},
        stiffness_{stops.stiffness},
        damping_{stops.damping},
        present_{std::isfinite(stops.lower) || std::isfinite(stops.upper)} {}
  EndStopTorqueOf() = default;

  /// Whether there are any, in one of the lanes.
  bool present() const noexcept { return any(present_.holds()); }
  /// At the angle of the load since power-on (rad) and its speed (rad/s).
  Push at(const Number& angle, const Number& speed) const noexcept {
    const Number above = angle - upper_;
    const Number below = angle - lower_;
    const Condition<Number> apart = above <= 0.0 && below >= 0.0;
    if (all(apart)) return {};
    const Condition<Number> at_upper = above > 0.0;
    const Number spring = stiffness_ * select<Number>(at_upper, above, below);
    const Number total = spring + damping_ * speed;
    const Number pushing = select<Number>(at_upper, maximum<Number>(total, 0.0), minimum<Number>(total, 0.0));
    return {select<Number>(apart, 0.0, spring), select<Number>(apart, 0.0, pushing)};
  }
  /// Energy in the springs (J).
  double stored(double angle) const noexcept {
    const double into = std::max({angle - upper_, lower_ - angle, 0.0});
    return 0.5 * stiffness_ * into * into;
  }

 private:
  Number lower_ = 0.0;      // rad
  Number upper_ = 0.0;      // rad
  Number stiffness_ = 0.0;  // N·m/rad
  Number damping_ = 0.0;    // N·m·s/rad
  Flag<Number> present_{};
};
using EndStopTorque = EndStopTorqueOf<double>;

}  // namespace motor
