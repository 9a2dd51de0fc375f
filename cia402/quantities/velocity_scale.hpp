#pragma once

#include <numbers>

namespace cia402 {

/// Velocities of the driving shaft in position units/s, of the motor in rad/s and rpm; accelerations and jerks
/// likewise, by s² and s³.
class VelocityScale {
 public:
  /// @p units_per_revolution: position units of a revolution of the motor, positive.
  explicit constexpr VelocityScale(double units_per_revolution) noexcept : revolution_{units_per_revolution} {}

  constexpr double radians(double units) const noexcept { return units / revolution_ * kTurn; }  ///< rad/s
  constexpr double units_of_radians(double radians) const noexcept { return radians / kTurn * revolution_; }
  constexpr double rpm(double units) const noexcept { return units * kMinute / revolution_; }
  constexpr double units_of_rpm(double rpm) const noexcept { return rpm * revolution_ / kMinute; }

 private:
  static constexpr double kTurn = 2.0 * std::numbers::pi;
  static constexpr double kMinute = 60.0;

  double revolution_;
};

}  // namespace cia402
