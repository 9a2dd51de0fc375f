#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

#include "cia402/base/limits.hpp"

namespace cia402 {

using TimeNs = std::chrono::nanoseconds;

/// Length of a cycle of the motion. Instants of set-points count from the beginning of the running one.
inline constexpr TimeNs kCycleTime = std::chrono::milliseconds{1};

inline constexpr double kEndless = std::numeric_limits<double>::infinity();

constexpr double seconds(TimeNs time) noexcept {
  return std::chrono::duration<double>(time).count();
}

/// T of 60C2h: @p value (1..255) · 10^@p index (-6..0) s; what is shorter than a cycle acts as one.
constexpr TimeNs interpolation_period(std::uint8_t value, std::int8_t index) noexcept {
  TimeNs period = std::chrono::seconds{value};
  for (int i = index; i < 0; ++i) period /= 10;
  return std::max(period, kCycleTime);
}

/// What objects and the kind of the RPDO say about cyclic and interpolated modes.
struct CyclicSettings {
  TimeNs period = kCycleTime;            ///< T, from one set-point to the next (60C2h), at least a cycle
  double deceleration = 0.0;             ///< 6084h, positive (position units/s²)
  double quick_stop_deceleration = 0.0;  ///< 6085h, positive (position units/s²)
  double torque_slope = 0.0;             ///< 6087h, positive (N·m/s)
  Span torque{-kEndless, kEndless};  ///< of 6072h, 6073h, 60E0h and 60E1h (N·m); csp, csv and ip leave it alone
  std::uint32_t missed_set_points = 3;  ///< so many in a row are one too many; 0: never
  bool is_supervised = false;           ///< set-points come by synchronous RPDOs, in Operational
  double position_window = 0.0;         ///< 6067h (position units); interpolated position only
  TimeNs position_window_time{};        ///< 6068h

  friend bool operator==(const CyclicSettings&, const CyclicSettings&) = default;
};

/// What is added to a set-point, or fed forward beside it.
struct Offsets {
  double position = 0.0;  ///< 60B0h (position units)
  double velocity = 0.0;  ///< 60B1h (position units/s)
  double torque = 0.0;    ///< 60B2h (N·m)
};

/// Bits of the controlword that concern these modes (6040h).
inline constexpr unsigned kHaltBit = 0x0100;
inline constexpr unsigned kInterpolationBit = 0x0010;

}  // namespace cia402
