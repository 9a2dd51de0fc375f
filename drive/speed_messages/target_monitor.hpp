#pragma once

#include <cmath>

#include "drive/base/elapsed.hpp"

namespace drive {

/// Whether speed setpoint and actual speed agree, with hysteresis: r2197.7 with an off-delay, r2199.4 with an
/// on-delay.
class TargetMonitor {
 public:
  /// Window p2163 (rad/s), hysteresis p2164 (rad/s), off-delay p2166 (s), on-delay p2167 (s).
  struct Limits {
    double window;
    double hysteresis;
    double off_delay;
    double on_delay;
  };

  /// Tells the @p deviation of setpoint and actual speed (rad/s) @p duration (s) later; true = target reached.
  bool update(double duration, double deviation, const Limits& limits) noexcept {
    const double distance = std::abs(deviation);
    if (distance <= limits.window) {
      reached_ = inside_ = true;
      outside_time_ = 0.0;
    } else {
      leave(duration, distance, limits);
    }
    if (!kept_ && inside_) [[unlikely]] {
      inside_time_ += duration;
      kept_ = elapsed(inside_time_, limits.on_delay);
    }
    return reached_;
  }
  /// Whether they have agreed for the on-delay, and have done so since.
  bool is_kept() const noexcept { return kept_; }
  /// Whether the on-delay runs.
  bool awaits() const noexcept { return inside_ && !kept_; }

 private:
  void leave(double duration, double distance, const Limits& limits) noexcept {
    const bool outside = distance > limits.window + limits.hysteresis;
    outside_time_ = outside ? outside_time_ + duration : 0.0;
    if (!outside) return;
    inside_ = kept_ = false;
    inside_time_ = 0.0;
    if (elapsed(outside_time_, limits.off_delay)) reached_ = false;
  }

  bool reached_ = false;
  bool inside_ = true;
  bool kept_ = true;
  double outside_time_ = 0.0;  // s
  double inside_time_ = 0.0;   // s
};

}  // namespace drive
