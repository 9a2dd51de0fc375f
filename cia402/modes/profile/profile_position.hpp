#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "cia402/base/demand.hpp"
#include "cia402/base/limits.hpp"
#include "cia402/modes/profile/set_point.hpp"
#include "cia402/modes/profile/set_point_places.hpp"
#include "cia402/motion/position_profile.hpp"
#include "cia402/motion/window.hpp"

namespace cia402 {

/// Profile position (6060h = 1; CiA 402-2): positions to set-points that the controlword hands over.
///
/// A set-point is planned with the objects that were taken with it, within the limits that are there when it
/// begins or goes on after a halt; what is written later acts with the next one.
class ProfilePosition {
 public:
  /// A motion brakes with 6084h and is held, and there is no set-point.
  void enter(const Motion& present) noexcept;
  /// The interrupted positioning goes on from @p present, be it at rest or not.
  void resume(const Motion& present) noexcept;
  /// Both places are cleared.
  void leave() noexcept { places_.clear(); }
  /// A write of the controlword, which was @p former before; with halt (bit 8) no set-point is taken.
  void controlword(std::uint16_t word, std::uint16_t former, const ProfilePositionSettings& settings) noexcept;
  /// The next 1 ms. Of @p settings 6067h, 6068h and, for the motion that was entered with, 6084h count.
  Demand cycle(const ProfilePositionSettings& settings, const Limits& limits, const Actual& actual) noexcept;
  /// Target reached, set-point acknowledge, and the following error, which is found outside. While a halt brakes
  /// or holds, bit 10 is not the mode's.
  ModeBits bits(bool following_error) const noexcept {
    return {.bit_10 = is_reached_, .bit_12 = places_.acknowledges(), .bit_13 = following_error};
  }
  /// Where the positioning leads or has led, or where the axis is held (position units, before 607Bh wraps it).
  double target() const noexcept { return target_.position; }

 private:
  static constexpr double kUnlimited = std::numeric_limits<double>::infinity();

  void aim_at(const SetPoint& set_point) noexcept;
  void plan() noexcept;
  void plan_next() noexcept;
  void brake(double deceleration) noexcept;
  double passing_velocity() const noexcept;
  void move() noexcept;
  void judge(const ProfilePositionSettings& settings) noexcept;

  SetPointPlaces places_{};
  PositionProfile profile_{};
  SetPointTarget target_{};
  Window window_{};
  Limits limits_{.velocity = kUnlimited, .acceleration = kUnlimited, .deceleration = kUnlimited};
  Actual actual_{};
  bool is_entering_ = false;  // in motion
  bool is_aimed_ = true;      // the target is that of the running set-point
  bool is_planned_ = true;    // the profile leads there
  bool is_capped_ = false;    // the speed cap is less than 6081h
  bool is_reached_ = false;   // bit 10
};

}  // namespace cia402
