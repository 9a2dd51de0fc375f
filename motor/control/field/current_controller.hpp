#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/math/pair.hpp"

namespace motor {

/// PI controllers of the current along and across the flux. The voltage stays within a circle, and the current
/// along the flux has the first claim on it; an axis at its limit integrates only what leads back from it.
template <class Number>
class CurrentController {
 public:
  using Components = PairOf<Number>;

  /// Fixes @p gains for steps of @p period (s).
  void configure(const CurrentControllerGains& gains, double period) noexcept {
    proportional_ = Pair{gains.d_proportional, gains.q_proportional};
    integral_ = proportional_ * Pair{period / gains.d_integral_time, period / gains.q_integral_time};
  }
  /// Starts with @p voltage (V) as what the integral parts give.
  void reset(const SpaceVectorOf<Number>& voltage = {}) noexcept {
    integral_voltage_ = pair(voltage);
    demand_ = 0.0;
    limited_ = Flag<Number>{};
  }
  /// Goes on in a frame that is turned by the direction @p by, after @p added (V) has joined the integral parts.
  void turn(const SpaceVectorOf<Number>& by, const SpaceVectorOf<Number>& added) noexcept {
    integral_voltage_ = turned_back<Number>(integral_voltage_ + pair(added), by.re, by.im);
  }
  /// Adds @p voltage (V) to the integral parts.
  void shift(const SpaceVectorOf<Number>& voltage) noexcept { integral_voltage_ += pair(voltage); }
  /// Voltage (V) for @p setpoint and @p current (A) in the same frame; @p forward (V) is added before the limit,
  /// the circle of radius @p limit (V).
  SpaceVectorOf<Number> step(const SpaceVectorOf<Number>& setpoint, const SpaceVectorOf<Number>& current,
                             const SpaceVectorOf<Number>& forward, const Number& limit) noexcept {
    const Components error = pair(setpoint) - pair(current);
    const Components wanted = proportional_ * error + integral_voltage_ + pair(forward);
    demand_ = dot(wanted, wanted);
    const Condition<Number> limited = demand_ > limit * limit;
    limited_ = limited;
    if (any(limited)) [[unlikely]]
      return vector(within(limited, wanted, error, limit));
    integral_voltage_ += integral_ * error;
    return vector(wanted);
  }
  /// Square of the voltage that the last step wanted (V²).
  Number demand() const noexcept { return demand_; }
  /// Whether the last step wanted more than the limit.
  Condition<Number> limited() const noexcept { return limited_.holds(); }

 private:
  /// The voltage where some are @p limited.
  Components within(const Condition<Number>& limited, const Components& wanted, const Components& error,
                    const Number& limit) noexcept {
    const Number scale = limit / sqrt(demand_);
    const Components given = both(scale) * wanted;
    const Components away = (wanted - given) * error;
    const Components next = integral_voltage_ + integral_ * error;
    integral_voltage_ = Components{select<Number>(!limited || away[0] <= 0.0, next[0], integral_voltage_[0]),
                                   select<Number>(!limited || away[1] <= 0.0, next[1], integral_voltage_[1])};
    return select(limited, given, wanted);
  }

  Components proportional_{};      // V/A
  Components integral_{};          // V/A a step
  Components integral_voltage_{};  // V
  Number demand_ = 0.0;
  Flag<Number> limited_{};
};

}  // namespace motor
