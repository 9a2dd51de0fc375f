#pragma once

#include "motor/math/number.hpp"

namespace motor {

/// Whole increments that an encoder gives while its shaft turns, and the speed by them. Numbers of increments are
/// whole, and exact up to 2^53.
template <class Number>
class EncoderTrack {
 public:
  /// The shaft is at @p revolutions + @p angle (rad, 0..2π) from its place at power-on; the increments of the true
  /// angle that it has come past since the last call.
  Number turn_to(const Number& revolutions, const Number& angle) noexcept {
    const Number within = floor(angle * per_radian);
    const Number moved = (revolutions - revolutions_) * per_revolution + (within - within_);
    revolutions_ = revolutions;
    within_ = within;
    past_mark += moved;
    return moved;
  }
  /// One period after the last call, @p counted increments have been counted.
  void follow(const Number& counted) noexcept {
    const Number next = speed + filter_gain * (counted * speed_per_increment - speed);
    speed = select<Number>(counted == 0.0 && abs(next) < kZeroSpeed, 0.0, next);
  }
  /// Whether the shaft has left the revolution that began with the last zero mark.
  Condition<Number> is_past_mark() const noexcept { return past_mark < 0.0 || past_mark >= per_revolution; }

  Number per_revolution = 1.0;       ///< increments
  Number per_radian = 1.0;           ///< increments
  Number speed_per_increment = 0.0;  ///< (rad/s) an increment in a period
  Number filter_gain = 1.0;
  Number past_mark = 0.0;  ///< increments past the last zero mark
  Number speed = 0.0;      ///< smoothed (rad/s)

 private:
  static constexpr double kZeroSpeed = 1e-6;  // rad/s, far below one increment a period

  Number revolutions_ = 0.0;
  Number within_ = 0.0;  // increments of the last revolution
};

}  // namespace motor
