#pragma once

#include "motor/control/signals.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// Below the changeover speed a machine without encoder is fed a turning current that it follows by itself; the
/// speed setpoint turns it, as fast as the shaft can follow.
template <class Number>
class FedStart {
 public:
  /// A current of @p amplitude (A) whose frequency changes by at most @p slope (electrical rad/s²).
  void configure(double amplitude, double slope) noexcept {
    amplitude_ = amplitude;
    slope_ = slope;
  }
  /// Begins on @p frame with the present @p current (A) in it.
  void start(const FrameOf<Number>& frame, const SpaceVectorOf<Number>& current = {}) noexcept {
    frame_ = frame;
    current_ = current;
  }
  /// One period towards @p frequency (electrical rad/s).
  void step(const Number& frequency) noexcept {
    frame_.direction = turned<Number>(frame_.direction, kControlPeriod * frame_.frequency);
    const Number most = slope_ * kControlPeriod;
    frame_.frequency += bounded<Number>(frequency - frame_.frequency, -most, most);
    const Number change = amplitude_ * kControlPeriod / kRampTime;
    current_.re += bounded<Number>(amplitude_ - current_.re, -change, change);
    current_.im += bounded<Number>(-current_.im, -change, change);
  }
  const FrameOf<Number>& frame() const noexcept { return frame_; }
  /// Setpoint in that frame (A).
  SpaceVectorOf<Number> current() const noexcept { return current_; }
  Number amplitude() const noexcept { return amplitude_; }

 private:
  static constexpr double kRampTime = 0.05;  // s, from nothing to the amplitude

  Number amplitude_ = 0.0;  // A
  Number slope_ = 0.0;      // rad/s²
  FrameOf<Number> frame_{};
  SpaceVectorOf<Number> current_{};
};

}  // namespace motor
