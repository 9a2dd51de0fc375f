#pragma once

#include <cmath>
#include <limits>

namespace drive {

/// Slopes of a ramp (rad/s²); infinite = step.
struct RampSlopes {
  double up = std::numeric_limits<double>::infinity();    ///< away from zero
  double down = std::numeric_limits<double>::infinity();  ///< towards zero
};

/// Slope (rad/s²) of a ramp that takes @p time (s) between zero and @p maximum_speed (rad/s); time 0 = step.
inline double ramp_slope(double maximum_speed, double time) noexcept {
  return time > 0.0 && maximum_speed > 0.0 ? maximum_speed / time : std::numeric_limits<double>::infinity();
}

/// Linear ramp of the speed setpoint. A reversal passes zero: down first, then up with the rest of the step.
class RampFunctionGenerator {
 public:
  /// Continues at @p speed (rad/s).
  void start(double speed) noexcept { output_ = speed; }
  /// Moves the output towards @p target (rad/s) for @p dt (s) and returns it.
  double step(double dt, double target, const RampSlopes& slopes) noexcept {
    if (std::abs(target - output_) <= 0.0) return output_;
    const bool reversal = output_ * target < 0.0;
    const bool slower = std::abs(target) < std::abs(output_);
    const double turning_point = reversal ? 0.0 : (slower ? target : output_);
    const double left = approach(turning_point, slopes.down, dt);
    if (left > 0.0) approach(target, slopes.up, left);
    return output_;
  }
  /// Setpoint behind the ramp, r1170 (rad/s).
  double output() const noexcept { return output_; }

 private:
  /// Moves straight to @p end with @p slope; returns the time that is left (s).
  double approach(double end, double slope, double time) noexcept {
    const double change = end - output_;
    if (std::abs(change) <= 0.0) return time;
    const double reach = slope * time;
    if (reach < std::abs(change)) {
      output_ += std::copysign(reach, change);
      return 0.0;
    }
    output_ = end;
    return time - std::abs(change) / slope;
  }

  double output_ = 0.0;  // rad/s
};

}  // namespace drive
