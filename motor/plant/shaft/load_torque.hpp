#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "motor/data/load.hpp"
#include "motor/math/rotation.hpp"

namespace motor {

/// Torque of a profile over time, walked through in steps of constant length.
class ProfileTorque {
 public:
  /// A point of a line: value and slope (N·m, N·m/s).
  struct Line {
    double torque = 0.0;
    double slope = 0.0;
  };

  explicit ProfileTorque(const TorqueProfile& profile) noexcept : profile_{profile} {}

  bool present() const noexcept { return profile_.count > 0; }
  /// Whether it stays as it is from now on.
  bool over() const noexcept { return !present() || (next_ == profile_.count && !profile_.repeats); }
  /// The line that holds from @p time on (s since power-on, ascending from call to call).
  Line at(double time) noexcept;

 private:
  TorqueProfile profile_;
  std::size_t next_ = 0;  // first point that is still to come
  double lap_start_ = 0.0;
  std::int64_t laps_ = 0;
};

/// All that hangs on a shaft, as one torque against positive rotation.
class LoadTorque {
 public:
  explicit LoadTorque(const Load& load) noexcept
      : constant_{load.constant_torque},
        fan_{load.fan_coefficient},
        pendulum_{load.pendulum_torque},
        profile_{load.profile} {}

  void set_constant(double torque) noexcept { constant_ = torque; }
  /// Whether it is more than a constant.
  bool varies() const noexcept { return fan_ > 0.0 || pendulum_ != 0.0 || profile_.present(); }
  /// Whether it stays as it is while the shaft stands.
  bool settled() const noexcept { return profile_.over(); }
  /// Prepares a step that begins at @p time (s) and at the load angle @p angle (rad).
  void begin(double time, double angle) noexcept {
    if (profile_.present()) line_ = profile_.at(time);
    turn_to(angle);
  }
  /// Puts the load at @p angle (rad) without any time passing.
  void turn_to(double angle) noexcept {
    if (pendulum_ != 0.0) direction_ = {std::cos(angle), std::sin(angle)};
  }
  /// Constant part (N·m).
  double constant() const noexcept { return constant_; }
  /// Torque (N·m) at @p speed (rad/s), @p angle (rad) and @p time (s) after the start of the step.
  double at(double speed, double angle, double time) const noexcept {
    double torque = constant_ + line_.torque + line_.slope * time + fan_ * speed * std::abs(speed);
    if (pendulum_ != 0.0) torque += pendulum_ * (direction_ * vector(small_rotation(angle))).im;
    return torque;
  }

 private:
  double constant_;
  double fan_;
  double pendulum_;
  ProfileTorque profile_;
  ProfileTorque::Line line_{};
  SpaceVector direction_{1.0, 0.0};  // of the load
};

/// Walls that only push.
class EndStopTorque {
 public:
  /// What a wall does (N·m, against positive rotation): what its spring holds, and what acts on the load.
  struct Push {
    double spring = 0.0;
    double total = 0.0;
  };

  explicit EndStopTorque(const EndStops& stops) noexcept : stops_{stops} {}

  bool present() const noexcept { return std::isfinite(stops_.lower) || std::isfinite(stops_.upper); }
  /// At the angle of the load since power-on (rad) and its speed (rad/s).
  Push at(double angle, double speed) const noexcept;
  /// Energy in the springs (J).
  double stored(double angle) const noexcept;

 private:
  EndStops stops_;
};

}  // namespace motor
