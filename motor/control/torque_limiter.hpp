#pragma once

#include "motor/control/control_settings.hpp"

namespace motor {

/// Brings the limits of torque together: those commanded (p1520, p1521), current and voltage, power (p1530,
/// p1531), and the DC link that must not rise further (Vdc_max controller).
template <class Number>
class TorqueLimiter {
 public:
  void configure(const ControlSettings& settings) noexcept {
    motoring_ = settings.motoring_power_limit;
    regenerative_ = -settings.regenerative_power_limit;
    vdc_max_ = settings.vdc_max > 0.0 ? settings.vdc_max : kNever;
  }
  /// Turns the power limits into torques at @p speed (rad/s), where @p due; often enough every millisecond.
  void follow(const Number& speed, const Condition<Number>& due) noexcept {
    const Number rate = 1.0 / maximum<Number>(abs(speed), kSlowest);
    const Condition<Number> forward = speed >= 0.0;
    power_.upper = select<Number>(due, rate * select<Number>(forward, motoring_, regenerative_), power_.upper);
    power_.lower = select<Number>(due, -rate * select<Number>(forward, regenerative_, motoring_), power_.lower);
  }
  /// Limits in force for @p commanded ones, @p reachable torque (N·m, either way), @p speed (rad/s) and
  /// @p dc_voltage (V).
  TorqueLimitsOf<Number> limits(const TorqueLimitsOf<Number>& commanded, const Number& reachable,
                                const Number& speed, const Number& dc_voltage) const noexcept {
    TorqueLimitsOf<Number> result{minimum<Number>(commanded.upper, minimum<Number>(reachable, power_.upper)),
                                  maximum<Number>(commanded.lower, maximum<Number>(-reachable, power_.lower))};
    if (const Condition<Number> high = dc_voltage > vdc_max_ - kBand; any(high))
      shed(high, result, speed, dc_voltage);
    return result;
  }

 private:
  static constexpr double kNever = 1e9;    // V
  static constexpr double kBand = 20.0;    // V, over which generating torque fades out
  static constexpr double kSlowest = 0.1;  // rad/s, below it power limits say nothing

  void shed(const Condition<Number>& high, TorqueLimitsOf<Number>& limits, const Number& speed,
            const Number& dc_voltage) const noexcept {
    const Number share = bounded<Number>((vdc_max_ - dc_voltage) / kBand, 0.0, 1.0);
    limits.lower = select<Number>(high && speed > 0.0 && limits.lower < 0.0, limits.lower * share, limits.lower);
    limits.upper = select<Number>(high && speed < 0.0 && limits.upper > 0.0, limits.upper * share, limits.upper);
  }

  Number motoring_ = 0.0;      // W
  Number regenerative_ = 0.0;  // W
  Number vdc_max_ = kNever;
  TorqueLimitsOf<Number> power_{};
};

}  // namespace motor
