#pragma once

#include <algorithm>

#include "motor/math/number.hpp"

namespace motor {

/// Settings of the speed controller.
struct SpeedControllerGains {
  double proportional = 0.0;   ///< p1460 (N·m·s/rad)
  double integral_time = 0.0;  ///< p1462 (s), 0 = no integral part

  friend bool operator==(const SpeedControllerGains&, const SpeedControllerGains&) = default;
};

/// Range the torque setpoint may take (N·m). Where the two cross, the lower one wins.
template <class Number>
struct TorqueLimitsOf {
  Number upper = 0.0;
  Number lower = 0.0;

  constexpr Number bound(const Number& torque) const noexcept {
    return maximum<Number>(lower, minimum<Number>(upper, torque));
  }
};
using TorqueLimits = TorqueLimitsOf<double>;

/// Torque that is known beforehand (N·m).
template <class Number>
struct TorqueForward {
  Number acceleration = 0.0;  ///< precontrol: what the setpoint's slope needs
  Number additional = 0.0;    ///< for a load that is known from elsewhere
};

/// PI speed controller. A reference model, the shaft as the proportional part and the precontrol would lead it,
/// feeds the integral part, so that a change of the setpoint leaves nothing to unwind and only loads are
/// integrated; at a torque limit nothing is integrated at all.
template <class Number = double>
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
  void reset(const Number& speed, const Number& torque = 0.0) noexcept {
    integral_torque_ = torque;
    reference_ = speed;
    delayed_ = speed;
    limited_ = Flag<Number>{};
  }
  /// Torque setpoint (N·m) for a speed setpoint and a measured speed (rad/s).
  Number step(const Number& setpoint, const Number& measured, const TorqueLimitsOf<Number>& limits,
              const TorqueForward<Number>& forward = {}) noexcept {
    const Number wanted =
        proportional_ * (setpoint - measured) + integral_torque_ + forward.acceleration + forward.additional;
    const Number torque = limits.bound(wanted);
    limited_ = torque < wanted || torque > wanted;
    follow(setpoint, measured, forward.acceleration);
    integral_torque_ = limits.bound(integral_torque_ + integral_ * (delayed_ - measured));
    return torque;
  }
  /// Whether the last step wanted more torque than the limits give (r1407.7).
  Condition<Number> limited() const noexcept { return limited_.holds(); }

 private:
  /// At a limit the model waits with the motor: nothing is left to integrate.
  void follow(const Number& setpoint, const Number& measured, const Number& acceleration_torque) noexcept {
    const Condition<Number> waits = limited_.holds();
    reference_ = select<Number>(
        waits, measured, reference_ + (model_ * (setpoint - reference_) + model_rate_ * acceleration_torque));
    delayed_ = select<Number>(waits, measured, delayed_ + model_lag_ * (reference_ - delayed_));
  }

  Number proportional_ = 0.0;     // N·m·s/rad
  Number integral_ = 0.0;         // N·m·s/rad a step
  Number model_ = 1.0;            // share of the deviation that the reference model covers in a step
  Number model_rate_ = 0.0;       // speed that a torque gives in a step (rad/s per N·m)
  Number model_lag_ = 1.0;        // share of the way to the model that its delayed image goes in a step
  Number integral_torque_ = 0.0;  // N·m
  Number reference_ = 0.0;        // rad/s
  Number delayed_ = 0.0;          // rad/s
  Flag<Number> limited_{};
};

}  // namespace motor
