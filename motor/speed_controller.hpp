#pragma once

#include <algorithm>

namespace motor {

/// Settings of the speed controller.
struct SpeedControllerGains {
  double proportional = 0.0;   ///< p1460 (N·m·s/rad)
  double integral_time = 0.0;  ///< p1462 (s), 0 = no integral part
};

/// Range the torque setpoint may take (N·m). Where the two cross, the lower one wins.
struct TorqueLimits {
  double upper = 0.0;
  double lower = 0.0;

  constexpr double bound(double torque) const noexcept { return std::max(lower, std::min(upper, torque)); }
};

/// PI speed controller. A first-order reference model feeds the integral part, so that a change of the setpoint
/// leaves nothing to unwind and only loads are integrated; at a torque limit nothing is integrated at all.
class SpeedController {
 public:
  /// Fixes @p gains for a shaft of @p inertia (kg·m²) and steps of @p period (s).
  void configure(const SpeedControllerGains& gains, double inertia, double period) noexcept {
    proportional_ = gains.proportional;
    integral_ = gains.integral_time > 0.0 ? gains.proportional * period / gains.integral_time : 0.0;
    model_ = std::min(1.0, gains.proportional * period / inertia);
  }
  /// Empties the integral part and starts the reference model at @p speed (rad/s).
  void reset(double speed) noexcept {
    integral_torque_ = 0.0;
    reference_ = speed;
    limited_ = false;
  }
  /// Torque setpoint (N·m) for a speed setpoint and a measured speed (rad/s).
  double step(double setpoint, double measured, const TorqueLimits& limits) noexcept {
    const double wanted = proportional_ * (setpoint - measured) + integral_torque_;
    const double torque = limits.bound(wanted);
    limited_ = torque < wanted || torque > wanted;
    // At a limit the model waits with the motor: nothing is left to integrate.
    reference_ = limited_ ? measured : reference_ + model_ * (setpoint - reference_);
    integral_torque_ = limits.bound(integral_torque_ + integral_ * (reference_ - measured));
    return torque;
  }
  /// Whether the last step wanted more torque than the limits give (r1407.7).
  bool limited() const noexcept { return limited_; }

 private:
  double proportional_ = 0.0;     // N·m·s/rad
  double integral_ = 0.0;         // N·m·s/rad a step
  double model_ = 1.0;            // share of the deviation that the reference model covers in a step
  double integral_torque_ = 0.0;  // N·m
  double reference_ = 0.0;        // rad/s
  bool limited_ = false;
};

}  // namespace motor
