#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "motor/machine_data.hpp"

namespace motor {

/// Incremental encoder: whole increments and the fraction to the next one, so that no position is lost by
/// rounding, and the speed as the difference quotient of the whole increments.
class Encoder {
 public:
  explicit Encoder(const MachineData& machine) noexcept
      : per_radian_{increments_per_revolution(machine) / (2.0 * std::numbers::pi)},
        tolerated_ripple_{kRipple * machine.rated_speed} {}

  /// Fixes the sampling period (s) and with it the smoothing of the measured speed.
  void configure(double period) noexcept {
    speed_per_increment_ = 1.0 / (per_radian_ * period);
    filter_time_ = std::clamp(period * (speed_per_increment_ / tolerated_ripple_ - 1.0), 0.0, kLongestFilter);
    filter_gain_ = period / (period + filter_time_);
  }
  /// Turns the shaft by @p angle (rad) within one period.
  void turn(double angle) noexcept {
    const double position = fraction_ + angle * per_radian_;
    const double whole = std::floor(position);
    fraction_ = position - whole;
    const auto moved = static_cast<std::int64_t>(whole);
    counts_ += moved;
    speed_ += filter_gain_ * (whole * speed_per_increment_ - speed_);
    if (moved == 0 && std::abs(speed_) < kZeroSpeed) speed_ = 0.0;
  }
  /// Increments since power-on; negative after turning backwards.
  std::int64_t counts() const noexcept { return counts_; }
  /// Measured speed (rad/s), smoothed with filter_time().
  double speed() const noexcept { return speed_; }
  /// Time constant of the smoothing (s): just enough for the encoder's resolution, 0 for a very fine one.
  double filter_time() const noexcept { return filter_time_; }

 private:
  static constexpr double kRipple = 1e-5;         // of the rated speed, what one increment may leave in the speed
  static constexpr double kLongestFilter = 2e-3;  // s, a coarse encoder is allowed to be heard
  static constexpr double kZeroSpeed = 1e-6;      // rad/s, far below one increment a period

  double per_radian_;
  double tolerated_ripple_;
  double speed_per_increment_ = 0.0;
  double filter_time_ = 0.0;
  double filter_gain_ = 1.0;
  double fraction_ = 0.0;  // of an increment, 0..1
  std::int64_t counts_ = 0;
  double speed_ = 0.0;
};

}  // namespace motor
