#pragma once

#include <cmath>

#include "motor/control/measurement.hpp"
#include "motor/identification/standstill/bench/standstill_bench.hpp"

namespace motor {

/// Voltage and current of a constant current, once the voltage has come to rest: means over windows of 0.1 s,
/// until two that follow each other are alike.
class SteadyMean {
 public:
  /// Takes what was measured along @p axis.
  void step(const Measurement& measured, SpaceVector axis) noexcept {
    voltage_sum_ = voltage_sum_ + measured.voltage;
    current_sum_ = current_sum_ + measured.current;
    if (++steps_ < kWindow) return;
    const SpaceVector before = voltage_;
    voltage_ = (1.0 / kWindow) * voltage_sum_;
    current_ = (1.0 / kWindow) * current_sum_;
    const double change = std::abs(dot(voltage_ - before, axis));
    steady_ = windows_ > 0 && change <= kTolerance * std::abs(dot(voltage_, axis));
    ++windows_;
    steps_ = 0;
    voltage_sum_ = {};
    current_sum_ = {};
  }
  bool steady() const noexcept { return steady_; }
  /// Whether it has become pointless to wait.
  bool overdue() const noexcept { return windows_ >= kMostWindows; }
  /// Of the last window (V).
  SpaceVector voltage() const noexcept { return voltage_; }
  /// Of the last window (A).
  SpaceVector current() const noexcept { return current_; }

 private:
  static constexpr int kWindow = steps_in(0.1);
  static constexpr int kMostWindows = 60;
  static constexpr double kTolerance = 2e-4;

  SpaceVector voltage_sum_{};
  SpaceVector current_sum_{};
  SpaceVector voltage_{};
  SpaceVector current_{};
  int steps_ = 0;
  int windows_ = 0;
  bool steady_ = false;
};

}  // namespace motor
