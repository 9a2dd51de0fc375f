#pragma once

#include <algorithm>

#include "motor/control/signals.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// Below the changeover speed a machine without encoder is fed a turning current that it follows by itself; the
/// speed setpoint turns it, as fast as the shaft can follow.
class FedStart {
 public:
  /// A current of @p amplitude (A) whose frequency changes by at most @p slope (electrical rad/s²).
  void configure(double amplitude, double slope) noexcept {
    amplitude_ = amplitude;
    slope_ = slope;
  }
  /// Begins on @p frame with the present @p current (A) in it.
  void start(const Frame& frame, SpaceVector current = {}) noexcept {
    frame_ = frame;
    current_ = current;
  }
  /// One period towards @p frequency (electrical rad/s).
  void step(double frequency) noexcept {
    frame_.direction = turned(frame_.direction, kControlPeriod * frame_.frequency);
    const double most = slope_ * kControlPeriod;
    frame_.frequency += std::clamp(frequency - frame_.frequency, -most, most);
    const double change = amplitude_ * kControlPeriod / kRampTime;
    current_.re += std::clamp(amplitude_ - current_.re, -change, change);
    current_.im += std::clamp(-current_.im, -change, change);
  }
  const Frame& frame() const noexcept { return frame_; }
  /// Setpoint in that frame (A).
  SpaceVector current() const noexcept { return current_; }
  double amplitude() const noexcept { return amplitude_; }

 private:
  static constexpr double kRampTime = 0.05;  // s, from nothing to the amplitude

  double amplitude_ = 0.0;  // A
  double slope_ = 0.0;      // rad/s²
  Frame frame_{};
  SpaceVector current_{};
};

}  // namespace motor
