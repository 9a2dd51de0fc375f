#pragma once

#include <cmath>

namespace drive {

/// A time told in cycles: cycle times are sums of rounded fractions, so a limit is met within a nanosecond.
constexpr bool elapsed(double time, double limit) noexcept {
  return time >= limit - 1e-9;
}

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

/// r2197.7, speed setpoint and actual speed agree, with hysteresis and off-delay.
class TargetMonitor {
 public:
  /// Window p2163 (rad/s), hysteresis p2164 (rad/s), off-delay p2166 (s).
  struct Limits {
    double window;
    double hysteresis;
    double off_delay;
  };

  /// Tells the @p deviation of setpoint and actual speed (rad/s) @p duration (s) later; true = target reached.
  bool update(double duration, double deviation, const Limits& limits) noexcept {
    const bool outside = std::abs(deviation) > limits.window + limits.hysteresis;
    outside_time_ = outside ? outside_time_ + duration : 0.0;
    if (std::abs(deviation) <= limits.window) reached_ = true;
    if (outside && elapsed(outside_time_, limits.off_delay)) reached_ = false;
    return reached_;
  }

 private:
  bool reached_ = false;
  double outside_time_ = 0.0;  // s
};

}  // namespace drive
