#pragma once

#include <cmath>

#include "drive/base/elapsed.hpp"

namespace drive {

/// Decides when a braking ramp has ended and the pulses may go off.
class StandstillMonitor {
 public:
  /// Speed threshold p1226 (rad/s), monitoring time p1227 (s), pulse suppression delay p1228 (s).
  struct Limits {
    double threshold;
    double monitoring_time;
    double delay;
  };

  /// A new braking begins.
  void restart() noexcept { *this = StandstillMonitor{}; }
  /// Tells the @p speed and the @p setpoint behind the ramp (rad/s) @p duration (s) later; true = pulses off. The
  /// monitoring time runs from the moment the setpoint, not the motor, is below the threshold.
  bool update(double duration, double speed, double setpoint, const Limits& limits) noexcept {
    setpoint_time_ = std::abs(setpoint) <= limits.threshold ? setpoint_time_ + duration : 0.0;
    const bool standstill = std::abs(speed) < limits.threshold || elapsed(setpoint_time_, limits.monitoring_time);
    delay_ = standstill ? delay_ + duration : 0.0;
    return standstill && elapsed(delay_, limits.delay);
  }

 private:
  double setpoint_time_ = 0.0;  // s
  double delay_ = 0.0;          // s
};

}  // namespace drive
