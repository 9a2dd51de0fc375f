#pragma once

#include <cmath>

namespace motor {

/// The closed current control loop seen from outside: torque follows its setpoint with a first-order lag.
class CurrentLoop {
 public:
  /// Fixes the lag of @p time_constant (s, 0 = none) for steps of @p period (s).
  void configure(double time_constant, double period) noexcept {
    gain_ = time_constant > 0.0 ? -std::expm1(-period / time_constant) : 1.0;
    remainder_ = time_constant / period * gain_;
  }
  /// One period with the torque setpoint held (N·m): exact, whatever the ratio of period and lag. Returns the mean
  /// torque of the period, which is what accelerates the shaft.
  double step(double setpoint) noexcept {
    const double mean = setpoint + remainder_ * (torque_ - setpoint);
    torque_ += gain_ * (setpoint - torque_);
    return mean;
  }
  /// Pulses inhibited: the currents are gone within a fraction of a period.
  void inhibit() noexcept { torque_ = 0.0; }

 private:
  double gain_ = 1.0;
  double remainder_ = 0.0;  // share of the first deviation that is left on average over a period
  double torque_ = 0.0;     // N·m
};

}  // namespace motor
