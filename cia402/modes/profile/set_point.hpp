#pragma once

#include <cstdint>
#include <optional>

#include "cia402/base/limits.hpp"
#include "cia402/motion/profile_limits.hpp"

namespace cia402 {

/// The objects of profile position, in position units and seconds.
struct ProfilePositionSettings {
  double target = 0.0;                      ///< 607Ah: a coordinate, or a way
  double velocity = 0.0;                    ///< 6081h
  double end_velocity = 0.0;                ///< 6082h
  double acceleration = 1.0;                ///< 6083h
  double deceleration = 1.0;                ///< 6084h
  std::int16_t motion_profile = 0;          ///< 6086h: 0 trapezoid, 1..3 jerk-limited
  double jerk = 1.0;                        ///< 60A4h:1
  std::uint16_t option_code = 0;            ///< 60F2h
  std::optional<double> position_window{};  ///< 6067h; none = the axis need not be near its target (FFFFFFFFh)
  std::uint16_t window_time = 0;            ///< 6068h (ms)
};

/// Bits of the controlword in profile position.
struct ProfilePositionBits {
  static constexpr std::uint16_t kNewSetPoint = 0x0010;
  static constexpr std::uint16_t kChangeImmediately = 0x0020;
  static constexpr std::uint16_t kRelative = 0x0040;
  static constexpr std::uint16_t kHalt = 0x0100;
  static constexpr std::uint16_t kChangeOnSetPoint = 0x0200;
};

/// A set-point as it was taken.
struct SetPoint {
  /// What its position counts from.
  enum class Base : std::uint8_t {
    Axis,    ///< a coordinate of the axis
    Target,  ///< a way from the target before
    Demand,  ///< a way from the demand
    Actual,  ///< a way from the actual value
  };
  /// How a coordinate is reached where 607Bh is in force (60F2h bits 6..7).
  enum class Route : std::uint8_t { Linear, Negative, Positive, Shortest };
  /// When the acknowledgement ends (60F2h bits 4..5).
  enum class Response : std::uint8_t {
    PlaceFree,         ///< bit 4 = 0, and there is a place for the next set-point
    Reached,           ///< the set-point is reached
    FallAfterReached,  ///< bit 4 falls after that
  };

  Base base = Base::Axis;
  Route route = Route::Linear;
  Response response = Response::PlaceFree;
  double position = 0.0;
  double end_velocity = 0.0;          ///< 6082h, not 0 = when it passes its target
  ProfileLimits limits{};             ///< before the caps of the axis
  bool changes_on_set_point = false;  ///< bit 9: the one before passes its target
};

/// What @p settings and the bits of the controlword @p word make a set-point of.
SetPoint make_set_point(std::uint16_t word, const ProfilePositionSettings& settings) noexcept;

/// The limits of @p wanted within those of the axis.
ProfileLimits capped(const ProfileLimits& wanted, const Limits& limits) noexcept;

/// From where a target is looked for (position units, before 607Bh wraps them).
struct SetPointOrigin {
  double target = 0.0;  ///< of the set-point before
  double demand = 0.0;
  double velocity = 0.0;      ///< of the demand (units/s)
  double stopping_way = 0.0;  ///< of the demand, with the deceleration of the set-point (units, not negative)
  double actual = 0.0;
};

/// A place to go to.
struct SetPointTarget {
  double position = 0.0;    ///< before 607Bh wraps it
  bool is_clipped = false;  ///< by a software limit
};

/// Where @p set_point leads from @p origin within what @p limits allow.
SetPointTarget target_of(const SetPoint& set_point, const SetPointOrigin& origin, const Limits& limits) noexcept;

}  // namespace cia402
