#pragma once

#include <cstdint>
#include <optional>

namespace drive {

/// Time that the unit has been switched on (ms), over all its lives if it keeps what it should (see
/// DriveUnit::continue_after()).
using Uptime = std::uint64_t;
/// Milliseconds since 1 January 1970, 0:00 UTC, without leap seconds.
using UtcTime = std::uint64_t;

inline constexpr std::uint64_t kMillisecondsOfADay = 24ULL * 60 * 60 * 1000;

/// When something happened.
struct TimeStamp {
  Uptime uptime = 0;
  std::optional<UtcTime> utc{};  ///< by the clock of the unit, if it ran then

  /// What parameters show of it.
  std::uint64_t shown() const noexcept { return utc.value_or(uptime); }

  friend bool operator==(const TimeStamp&, const TimeStamp&) = default;
};

/// The operating time as it was last told, and how far UTC is ahead of it.
struct TimeLine {
  Uptime now = 0;
  std::optional<std::int64_t> utc_ahead{};  ///< ms; nothing while there is no UTC

  std::optional<UtcTime> utc() const noexcept {
    if (!utc_ahead) return std::nullopt;
    return static_cast<UtcTime>(static_cast<std::int64_t>(now) + *utc_ahead);
  }
  TimeStamp stamp() const noexcept { return {now, utc()}; }
};

}  // namespace drive
