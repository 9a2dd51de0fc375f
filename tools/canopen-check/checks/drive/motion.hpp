#pragma once

#include <optional>

#include "tools/canopen-check/checks/drive/axis.hpp"

namespace conformance {

// Small motions: an eighth to a half of a revolution, at most half a revolution a second.

/// How an axis in profile position mode is moved.
struct Travel {
  std::int64_t base = 0;     ///< 6064h in the beginning
  std::int64_t quarter = 0;  ///< of a revolution, towards where there is room within 607Dh
  std::int64_t window = 0;   ///< that counts as reached
};

/// Position units of a revolution of the motor, by 608Fh, or 6091h and 6092h; 0, and the axis is skipped, where
/// the objects do not tell.
[[nodiscard]] double revolution_of(Axis& axis);
/// A slow velocity: a quarter of a revolution a second, or what the profile acceleration reaches in 100 ms; 0, and
/// the axis is skipped, where the objects tell neither.
[[nodiscard]] std::int64_t slow_velocity(Axis& axis);

/// Profile position mode in Operation enabled, and how far to move; nothing, and the axis is skipped, if not.
[[nodiscard]] std::optional<Travel> prepare_positioning(Axis& axis);
/// Profile velocity mode in Operation enabled, at rest; false, and the axis is skipped, if not.
bool prepare_turning(Axis& axis);

// Bits of the controlword in profile position mode.
inline constexpr std::uint16_t kNewSetPoint = 0x0010, kChangeImmediately = 0x0020, kRelative = 0x0040;

/// Writes 607Ah and gives the edge of bit 4, with @p bits beside it, and takes it back once it is acknowledged;
/// false, and the axis is skipped, if it is not.
bool start_positioning(Axis& axis, std::int64_t target, std::uint16_t bits = 0);

/// Where an axis has come to rest, and how far it was on its way.
struct Rest {
  std::int64_t position = 0, lowest = 0, highest = 0;
};
/// Waits until 6064h has not left @p window for 100 ms, for 5 s at the longest.
[[nodiscard]] Rest settle(Axis& axis, std::int64_t window);
/// True if 6064h stays within @p window of @p position for @p span.
[[nodiscard]] bool stays(Axis& axis, std::int64_t position, std::int64_t window, canopen::Duration span = kWatch);
/// True if 606Ch comes to @p velocity within @p tolerance, in 3 s at the longest.
[[nodiscard]] bool turns(Axis& axis, std::int64_t velocity, std::int64_t tolerance);

/// Something that keeps an axis moving: profile velocity mode if it has that, else a positioning.
struct Motion {
  bool by_velocity = false;
  std::int64_t velocity = 0;  ///< about; above 0
  Travel travel{};            ///< of a positioning: to two quarters
};
/// Starts it and waits until the axis moves; nothing, and the axis is skipped, if it does not.
[[nodiscard]] std::optional<Motion> start_motion(Axis& axis);
/// Waits until the axis stands.
bool stands(Axis& axis, const Motion& motion);

}  // namespace conformance
