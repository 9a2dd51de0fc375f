#pragma once

#include <algorithm>

namespace motor {

/// Settings of the speed controller.
struct SpeedControllerGains {
  double proportional = 0.0;   ///< p1460 (N·m·s/rad)
  double integral_time = 0.0;  ///< p1462 (s), 0 = no integral part

  friend bool operator==(const SpeedControllerGains&, const SpeedControllerGains&) = default;
};

/// Range the torque setpoint may take (N·m). Where the two cross, the lower one wins.
struct TorqueLimits {
  double upper = 0.0;
  double lower = 0.0;

  constexpr double bound(double torque) const noexcept { return std::max(lower, std::min(upper, torque)); }
};

/// Torque that is known beforehand (N·m).
struct TorqueForward {
  double acceleration = 0.0;  ///< precontrol: what the setpoint's slope needs
  double additional = 0.0;    ///< for a load that is known from elsewhere
};

/// PI speed controller. A reference model, the shaft as the proportional part and the precontrol would lead it,
/// feeds the integral part, so that a change of the setpoint leaves nothing to unwind and only loads are
/// integrated; at a torque limit nothing is integrated at all.
class SpeedController {
 public:
  /// Fixes @p gains for a shaft of @p inertia (kg·m²) and steps of @p period (s); the torque comes @p delay (s)
  /// late.
  void configure(const SpeedControllerGains& gains, double inertia, double period, double delay = 0.0) noexcept {
    proportional_ = gains.proportional;
    integral_ = gains.integral_time > 0.0 ? gains.proportional * period / gains.integral_time : 0.0;
    model_ = std::min(1.0, gains.proportional * period / inertia);
    model_rate_ = period / inertia;
    model_lag_ = period / (period + delay);
  }
  /// Starts at @p speed (rad/s) with @p torque (N·m) as what the integral part gives.
  void reset(double speed, double torque = 0.0) noexcept {
    integral_torque_ = torque;
    reference_ = speed;
    delayed_ = speed;
    limited_ = false;
  }
  /// Torque setpoint (N·m) for a speed setpoint and a measured speed (rad/s).
  double step(double setpoint, double measured, const TorqueLimits& limits,
              const TorqueForward& forward = {}) noexcept {
    const double wanted =
        proportional_ * (setpoint - measured) + integral_torque_ + forward.acceleration + forward.additional;
    const double torque = limits.bound(wanted);
    limited_ = torque < wanted || torque > wanted;
    follow(setpoint, measured, forward.acceleration);
    integral_torque_ = limits.bound(integral_torque_ + integral_ * (delayed_ - measured));
    return torque;
  }
  /// Whether the last step wanted more torque than the limits give (r1407.7).
  bool limited() const noexcept { return limited_; }

 private:
  void follow(double setpoint, double measured, double acceleration_torque) noexcept {
    if (limited_) {  // the model waits with the motor: nothing is left to integrate
      reference_ = measured;
      delayed_ = measured;
      return;
    }
    reference_ += model_ * (setpoint - reference_) + model_rate_ * acceleration_torque;
    delayed_ += model_lag_ * (reference_ - delayed_);
  }

  double proportional_ = 0.0;     // N·m·s/rad
  double integral_ = 0.0;         // N·m·s/rad a step
  double model_ = 1.0;            // share of the deviation that the reference model covers in a step
  double model_rate_ = 0.0;       // speed that a torque gives in a step (rad/s per N·m)
  double model_lag_ = 1.0;        // share of the way to the model that its delayed image goes in a step
  double integral_torque_ = 0.0;  // N·m
  double reference_ = 0.0;        // rad/s
  double delayed_ = 0.0;          // rad/s
  bool limited_ = false;
};

}  // namespace motor
