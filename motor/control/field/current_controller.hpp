#pragma once

#include <cmath>

#include "motor/control/control_settings.hpp"
#include "motor/math/pair.hpp"

namespace motor {

/// PI controllers of the current along and across the flux. The voltage stays within a circle, and the current
/// along the flux has the first claim on it; an axis at its limit integrates only what leads back from it.
class CurrentController {
 public:
  /// Fixes @p gains for steps of @p period (s).
  void configure(const CurrentControllerGains& gains, double period) noexcept {
    proportional_ = Pair{gains.d_proportional, gains.q_proportional};
    integral_ = proportional_ * Pair{period / gains.d_integral_time, period / gains.q_integral_time};
  }
  /// Starts with @p voltage (V) as what the integral parts give.
  void reset(SpaceVector voltage = {}) noexcept {
    integral_voltage_ = pair(voltage);
    demand_ = 0.0;
    limited_ = false;
  }
  /// Goes on in a frame that is turned by the direction @p by, after @p added (V) has joined the integral parts.
  void turn(SpaceVector by, SpaceVector added) noexcept {
    integral_voltage_ = turned_back(integral_voltage_ + pair(added), by.re, by.im);
  }
  /// Adds @p voltage (V) to the integral parts.
  void shift(SpaceVector voltage) noexcept { integral_voltage_ += pair(voltage); }
  /// Voltage (V) for @p setpoint and @p current (A) in the same frame; @p forward (V) is added before the limit,
  /// the circle of radius @p limit (V).
  SpaceVector step(SpaceVector setpoint, SpaceVector current, SpaceVector forward, double limit) noexcept {
    const Pair error = pair(setpoint) - pair(current);
    const Pair wanted = proportional_ * error + integral_voltage_ + pair(forward);
    demand_ = dot(wanted, wanted);
    limited_ = demand_ > limit * limit;
    if (limited_) [[unlikely]]
      return vector(bounded(wanted, error, limit));
    integral_voltage_ += integral_ * error;
    return vector(wanted);
  }
  /// Square of the voltage that the last step wanted (V²).
  double demand() const noexcept { return demand_; }
  /// Whether the last step wanted more than the limit.
  bool limited() const noexcept { return limited_; }

 private:
  Pair bounded(Pair wanted, Pair error, double limit) noexcept {
    const Pair given = both(limit / std::sqrt(demand_)) * wanted;
    const Pair away = (wanted - given) * error;
    if (away[0] <= 0.0) integral_voltage_[0] += integral_[0] * error[0];
    if (away[1] <= 0.0) integral_voltage_[1] += integral_[1] * error[1];
    return given;
  }

  Pair proportional_{};      // V/A
  Pair integral_{};          // V/A a step
  Pair integral_voltage_{};  // V
  double demand_ = 0.0;
  bool limited_ = false;
};

}  // namespace motor
