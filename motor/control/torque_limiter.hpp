#pragma once

#include <algorithm>
#include <cmath>

#include "motor/control/control_settings.hpp"

namespace motor {

/// Brings the limits of torque together: those commanded (p1520, p1521), current and voltage, power (p1530,
/// p1531), and the DC link that must not rise further (Vdc_max controller).
class TorqueLimiter {
 public:
  void configure(const ControlSettings& settings) noexcept {
    motoring_ = settings.motoring_power_limit;
    regenerative_ = -settings.regenerative_power_limit;
    vdc_max_ = settings.vdc_max > 0.0 ? settings.vdc_max : kNever;
  }
  /// Turns the power limits into torques at @p speed (rad/s); often enough every millisecond.
  void follow(double speed) noexcept {
    const double rate = 1.0 / std::max(std::abs(speed), kSlowest);
    const bool forward = speed >= 0.0;
    power_ = {rate * (forward ? motoring_ : regenerative_), -rate * (forward ? regenerative_ : motoring_)};
  }
  /// Limits in force for @p commanded ones, @p reachable torque (N·m, either way), @p speed (rad/s) and
  /// @p dc_voltage (V).
  TorqueLimits limits(const TorqueLimits& commanded, double reachable, double speed,
                      double dc_voltage) const noexcept {
    TorqueLimits result{std::min(commanded.upper, std::min(reachable, power_.upper)),
                        std::max(commanded.lower, std::max(-reachable, power_.lower))};
    if (dc_voltage > vdc_max_ - kBand) shed(result, speed, dc_voltage);
    return result;
  }

 private:
  static constexpr double kNever = 1e9;    // V
  static constexpr double kBand = 20.0;    // V, over which generating torque fades out
  static constexpr double kSlowest = 0.1;  // rad/s, below it power limits say nothing

  void shed(TorqueLimits& limits, double speed, double dc_voltage) const noexcept {
    const double share = std::clamp((vdc_max_ - dc_voltage) / kBand, 0.0, 1.0);
    if (speed > 0.0 && limits.lower < 0.0) limits.lower *= share;
    if (speed < 0.0 && limits.upper > 0.0) limits.upper *= share;
  }

  double motoring_ = 0.0;      // W
  double regenerative_ = 0.0;  // W
  double vdc_max_ = kNever;
  TorqueLimits power_{};
};

}  // namespace motor
