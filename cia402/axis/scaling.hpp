#pragma once

#include "cia402/objects/axis_values.hpp"
#include "cia402/quantities/polarity.hpp"
#include "cia402/quantities/position_scale.hpp"
#include "cia402/quantities/rated_scale.hpp"
#include "cia402/quantities/velocity_scale.hpp"

namespace cia402 {

/// What the objects of an axis are relative to (608Fh, 6091h, 6092h, 607Eh, 6075h, 6076h). Positions inside have
/// the sign that masters see, velocities are theirs by time.
class Scaling {
 public:
  explicit Scaling(const AxisValues& values) noexcept
      : polarity_{values.polarity.get()},
        position_{PositionMechanics{.increments = values.encoder_increments.get(),
                                    .motor_revolutions = values.gear_motor.get(),
                                    .shaft_revolutions = values.gear_shaft.get(),
                                    .feed = values.feed.get(),
                                    .feed_revolutions = values.feed_shaft.get()}},
        velocity_{position_.units_per_revolution()},
        torque_{values.motor_rated_torque.get()},
        current_{values.motor_rated_current.get()} {}

  const PositionScale& position() const noexcept { return position_; }
  const RatedScale& torque() const noexcept { return torque_; }
  const RatedScale& current() const noexcept { return current_; }

  /// The sign of a position of the motor as masters see it.
  double sign() const noexcept { return polarity_.position(1.0); }
  /// A velocity object (60FFh) as a velocity of the position, and the other way round.
  double velocity(double object) const noexcept { return polarity_.position(polarity_.velocity(object)); }

  /// A velocity of the position (units/s) as the motor turns (rad/s), and the other way round.
  double motor_speed(double velocity) const noexcept { return sign() * velocity_.radians(velocity); }
  double velocity_of(double motor_speed) const noexcept {
    return sign() * velocity_.units_of_radians(motor_speed);
  }
  /// rpm of the motor, without a sign of 607Eh (6080h), in units/s.
  double units_of_rpm(double rpm) const noexcept { return velocity_.units_of_rpm(rpm); }
  double rpm(double velocity) const noexcept { return velocity_.rpm(velocity); }

 private:
  Polarity polarity_;
  PositionScale position_;
  VelocityScale velocity_;
  RatedScale torque_;
  RatedScale current_;
};

}  // namespace cia402
