#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace drive {

/// p1134: what happens to the slope when the target moves while the ramp runs.
enum class RoundingType : std::uint8_t {
  Continuous,     ///< it changes with the jerk of the rounding; the output may run past its new target
  Discontinuous,  ///< where that would happen it is 0 at once
};

/// Slopes of a ramp (rad/s²), infinite = step, and the times in which they build up and vanish.
struct RampSlopes {
  double up = std::numeric_limits<double>::infinity();    ///< away from zero
  double down = std::numeric_limits<double>::infinity();  ///< towards zero
  double initial_rounding = 0.0;                 ///< p1130 or p1136, from 0 to the slope (s); 0 with p1115 = 0
  double final_rounding = 0.0;                   ///< p1131 or p1137, from the slope to 0 (s); 0 with p1115 = 0
  RoundingType type = RoundingType::Continuous;  ///< p1134

  friend bool operator==(const RampSlopes&, const RampSlopes&) = default;
};

/// Slope (rad/s²) of a ramp that takes @p time (s) between zero and @p maximum_speed (rad/s); time 0 = step.
inline double ramp_slope(double maximum_speed, double time) noexcept {
  return time > 0.0 && maximum_speed > 0.0 ? maximum_speed / time : std::numeric_limits<double>::infinity();
}

/// Ramp of the speed setpoint with rounded ends: parts of constant jerk, planned when the target or the slopes
/// change and followed exactly, so that the length of the steps does not show. A reversal passes zero with the
/// slope towards zero, and goes on with the other.
class RampFunctionGenerator {
 public:
  /// Continues at @p speed (rad/s), without slope.
  void start(double speed) noexcept {
    output_ = target_ = speed;
    finish();
  }
  /// From now on the output goes to @p target (rad/s) with @p slopes.
  void lead(double target, const RampSlopes& slopes) noexcept {
    if (target < target_ || target > target_ || !(slopes == slopes_)) {
      target_ = target;
      slopes_ = slopes;
      plan();
    }
  }
  /// Whether the output is where it goes to.
  bool rests() const noexcept { return part_ >= count_; }
  /// Moves the output for @p dt (s).
  [[gnu::always_inline]] void advance_by(double dt) noexcept {
    if (part_ < count_) go_on(dt);
  }
  /// Moves the output towards @p target (rad/s) for @p dt (s) and returns it.
  double step(double dt, double target, const RampSlopes& slopes) noexcept {
    lead(target, slopes);
    advance_by(dt);
    return output_;
  }
  /// Setpoint behind the ramp, r1170 (rad/s).
  double output() const noexcept { return output_; }
  /// Slope of the setpoint now, for a precontrol (rad/s²); 0 where it jumps.
  double acceleration() const noexcept { return acceleration_; }

 private:
  /// A stretch of constant jerk.
  struct Part {
    double slope;     // rad/s², at its start
    double jerk;      // rad/s³
    double duration;  // s
  };
  void plan() noexcept;
  void plan_towards(double slope) noexcept;
  void add(const Part& part) noexcept;
  double slope_limit() const noexcept;
  void go_on(double dt) noexcept;
  double advance(double time) noexcept;
  double time_to_zero() const noexcept;
  void finish() noexcept;

  double target_ = 0.0;  // rad/s
  RampSlopes slopes_{};
  double output_ = 0.0;        // rad/s
  double acceleration_ = 0.0;  // rad/s²

  std::array<Part, 4> parts_{};
  std::size_t count_ = 0;
  std::size_t part_ = 0;
  double time_ = 0.0;          // s, since the part began
  double start_output_ = 0.0;  // rad/s, where it began
};

}  // namespace drive
