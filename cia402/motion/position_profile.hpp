#pragma once

#include "cia402/motion/jerk_profile.hpp"
#include "cia402/motion/profile_limits.hpp"
#include "drive/positioning/profile/trapezoid_profile.hpp"

namespace cia402 {

/// Demand of a point-to-point positioning (6086h): trapezoid or seven segments, as each order says; the motion
/// goes on from one to the other. It may pass its target at a velocity.
class PositionProfile {
 public:
  /// At @p position, going on with @p velocity until the next order (position units; s).
  void place(double position, double velocity = 0.0) noexcept;
  /// To @p target (finite) from the present motion. If @p passing_velocity (units/s, with its sign) leads beyond
  /// it in the direction of the way there, the target is passed with that velocity, as far as the limits and the
  /// way allow; otherwise the motion ends there. A motion that would overrun its target brakes with the larger of
  /// the old and the new deceleration (and jerk); if that does not help, it stops behind the target and turns
  /// back.
  void move_to(double target, const ProfileLimits& limits, double passing_velocity = 0.0) noexcept;
  /// To rest with @p deceleration (units/s²), wherever that is.
  void brake(double deceleration) noexcept;
  /// Goes on for @p dt (s) or to an event. After Passed the next order is to come before the next advance.
  ProfileAdvance advance(double dt) noexcept;

  double position() const noexcept { return is_jerk_limited_ ? jerk_.position() : trapezoid_.position(); }
  double velocity() const noexcept { return is_jerk_limited_ ? jerk_.velocity() : trapezoid_.velocity(); }
  double acceleration() const noexcept {
    return is_jerk_limited_ ? jerk_.acceleration() : trapezoid_.acceleration();
  }
  /// From here to rest with @p limits, without regard to a target (units, in the direction of the velocity).
  double stopping_way(const ProfileLimits& limits) const noexcept;
  /// At rest, and nothing will move it.
  bool stands() const noexcept { return is_jerk_limited_ ? jerk_.stands() : trapezoid_.stands(); }
  /// Stands at the target of move_to().
  bool has_arrived() const noexcept { return is_jerk_limited_ ? jerk_.has_arrived() : trapezoid_.has_arrived(); }

 private:
  void use_trapezoid() noexcept;
  void use_jerk(double target, const ProfileLimits& limits) noexcept;
  void move_trapezoid(double target, const ProfileLimits& limits, double passing_velocity) noexcept;
  ProfileAdvance advance_trapezoid(double dt) noexcept;
  ProfileAdvance pass_within(double dt) noexcept;
  bool is_past(const drive::TrapezoidProfile& motion) const noexcept {
    return (motion.position() - passed_target_) * passing_direction_ >= 0.0;
  }

  drive::TrapezoidProfile trapezoid_{};
  JerkProfile jerk_{};
  bool is_jerk_limited_ = false;
  double passing_direction_ = 0.0;  // of a trapezoid that is to pass its target; 0 = it is not
  double passed_target_ = 0.0;
};

/// The highest velocity (units/s) from which a motion with @p limits comes to rest within @p way (units).
double highest_velocity_before(double way, const ProfileLimits& limits) noexcept;

}  // namespace cia402
