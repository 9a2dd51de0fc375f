#pragma once

#include <algorithm>

namespace reference {

/// Speed controller of the reference solutions: PI, one sample T_s, nothing integrated while it is limited.
class SpeedPi {
 public:
  SpeedPi(double gain, double integral_time, double torque_limit, double period) noexcept
      : gain_{gain}, integral_gain_{gain / integral_time * period}, limit_{torque_limit} {}

  /// Torque (N·m) for a setpoint and a speed (rad/s).
  double step(double setpoint, double speed) noexcept {
    const double error = setpoint - speed;
    const double wanted = gain_ * error + integral_;
    const double torque = std::clamp(wanted, -limit_, limit_);
    if (wanted == torque || (wanted > 0.0) != (error > 0.0)) integral_ += integral_gain_ * error;
    return torque;
  }

 private:
  double gain_;
  double integral_gain_;
  double limit_;
  double integral_ = 0.0;
};

}  // namespace reference
