#pragma once

#include <cstddef>

#include "drive/positioning/profile/sliding_mean.hpp"
#include "drive/positioning/profile/trapezoid_profile.hpp"

namespace drive {

/// Setpoint of a motion in cycles of 1 ms: a trapezoid in continuous time, and behind it the jerk limiting as its
/// mean over the last Tr. Limits, targets and braking points are those of the trapezoid; what the controller
/// follows is the mean.
class MotionGenerator {
 public:
  /// Longest time of the jerk limiting, in cycles.
  static constexpr std::size_t kMostJerkCycles = 1000;

  /// Without memory there is no jerk limiting, and set_jerk_time() has no effect.
  explicit MotionGenerator(bool has_jerk_memory);

  /// At rest at @p position (LU), without target.
  void place(double position) noexcept;
  /// As TrapezoidProfile::move_to(), brake(), shift(); a shift moves the whole memory of the mean.
  void move_to(double target, const MotionLimits& limits, bool keeps_larger_deceleration = false) noexcept {
    trapezoid_.move_to(target, limits, keeps_larger_deceleration);
  }
  void brake(double deceleration) noexcept { trapezoid_.brake(deceleration); }
  void shift(double by) noexcept { trapezoid_.shift(by); }
  /// Tr (s), rounded up to whole cycles and kMostJerkCycles at most; 0 = off. Acts at standstill only: at once,
  /// or when the motion has come to rest.
  void set_jerk_time(double seconds) noexcept;

  /// Goes on by @p dt (s), or to an event; what is left is to be advanced by as well. Calls that add up to 1 ms
  /// are a cycle, at whose end the mean goes on.
  TrapezoidProfile::Advance advance(double dt, bool stops_at_braking_point = false,
                                    bool stops_at_standstill = false) noexcept;

  /// Of the mean, at the end of the last cycle.
  double position() const noexcept { return trapezoid_.position() - mean_.lag(); }                       ///< LU
  double velocity() const noexcept { return is_limiting() ? mean_.velocity() : trapezoid_.velocity(); }  ///< LU/s
  double acceleration() const noexcept {
    return is_limiting() ? mean_.acceleration() : trapezoid_.acceleration();
  }  ///< LU/s²
  /// At rest and with nothing to do, the mean too.
  bool stands() const noexcept { return trapezoid_.stands() && mean_.is_settled(); }
  /// Whether jerk limiting is on and the mean is not yet where the trapezoid is.
  bool is_smoothing() const noexcept { return !mean_.is_settled(); }
  /// Tr in force (s), 0 = off.
  double jerk_time() const noexcept { return static_cast<double>(mean_.cycles()) * kMotionCycle; }
  /// What the mean is made of.
  const TrapezoidProfile& unlimited() const noexcept { return trapezoid_; }

 private:
  bool is_limiting() const noexcept { return mean_.cycles() > 0; }
  void finish_cycle() noexcept;

  TrapezoidProfile trapezoid_{};
  SlidingMean mean_;
  double elapsed_ = 0.0;           // s, of the running cycle
  std::size_t wanted_cycles_ = 0;  // of the mean
  bool is_at_rest_ = true;         // nothing has moved in the running cycle, nor had at its beginning
};

}  // namespace drive
