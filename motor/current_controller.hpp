#pragma once

#include <algorithm>
#include <cmath>

#include "motor/control_settings.hpp"
#include "motor/space_vector.hpp"

namespace motor {

/// PI controllers of the current along and across the flux. The voltage stays within a circle, and the current
/// along the flux has the first claim on it; an axis at its limit integrates only what leads back from it.
class CurrentController {
 public:
  /// Fixes @p gains for steps of @p period (s).
  void configure(const CurrentControllerGains& gains, double period) noexcept {
    proportional_ = {gains.d_proportional, gains.q_proportional};
    integral_ = {gains.d_proportional * period / gains.d_integral_time,
                 gains.q_proportional * period / gains.q_integral_time};
  }
  /// Starts with @p voltage (V) as what the integral parts give.
  void reset(SpaceVector voltage = {}) noexcept {
    integral_voltage_ = voltage;
    demand_ = 0.0;
    limited_ = false;
  }
  /// Goes on in a frame that is turned by the direction @p by, after @p added (V) has joined the integral parts.
  void turn(SpaceVector by, SpaceVector added) noexcept {
    integral_voltage_ = (integral_voltage_ + added) * conjugate(by);
  }
  /// Adds @p voltage (V) to the integral parts.
  void shift(SpaceVector voltage) noexcept { integral_voltage_ = integral_voltage_ + voltage; }
  /// Voltage (V) for @p setpoint and @p current (A) in the same frame; @p forward (V) is added before the limit,
  /// the circle of radius @p limit (V).
  SpaceVector step(SpaceVector setpoint, SpaceVector current, SpaceVector forward, double limit) noexcept {
    const SpaceVector error = setpoint - current;
    const SpaceVector wanted{proportional_.re * error.re + integral_voltage_.re + forward.re,
                             proportional_.im * error.im + integral_voltage_.im + forward.im};
    demand_ = norm(wanted);
    limited_ = demand_ > limit * limit;
    if (!limited_) {
      integral_voltage_.re += integral_.re * error.re;
      integral_voltage_.im += integral_.im * error.im;
      return wanted;
    }
    return bounded(wanted, error, limit);
  }
  /// Square of the voltage that the last step wanted (V²).
  double demand() const noexcept { return demand_; }
  /// Whether the last step wanted more than the limit.
  bool limited() const noexcept { return limited_; }

 private:
  SpaceVector bounded(SpaceVector wanted, SpaceVector error, double limit) noexcept {
    const SpaceVector given = (limit / std::sqrt(demand_)) * wanted;
    if ((wanted.re - given.re) * error.re <= 0.0) integral_voltage_.re += integral_.re * error.re;
    if ((wanted.im - given.im) * error.im <= 0.0) integral_voltage_.im += integral_.im * error.im;
    return given;
  }

  SpaceVector proportional_{};  // V/A
  SpaceVector integral_{};      // V/A a step
  SpaceVector integral_voltage_{};
  double demand_ = 0.0;
  bool limited_ = false;
};

}  // namespace motor
