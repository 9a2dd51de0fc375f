#pragma once

#include <cmath>

#include "drive/base/elapsed.hpp"

namespace drive {

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
