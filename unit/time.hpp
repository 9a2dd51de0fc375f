#pragma once

#include <chrono>
#include <optional>

#include "drive/messages/time_stamp.hpp"

namespace unit {

/// Resolution of every time of the unit: 1 ns.
using Duration = std::chrono::nanoseconds;

/// Tag of the time line that the owner of a unit tells; the unit never reads a clock.
struct ToldClock {
  // NOLINTBEGIN(readability-identifier-naming): the names that <chrono> asks of a clock
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<ToldClock, Duration>;
  static constexpr bool is_steady = true;
  // NOLINTEND(readability-identifier-naming)
};

/// A point on the monotonic time line of the owner.
using TimePoint = ToldClock::time_point;

/// "Never": later than every deadline.
inline constexpr TimePoint kNever = TimePoint::max();

/// The wall clock of the machine that the owner runs on; the unit asks it only if p3103 makes it the answer of an
/// NTP server.
class HostClock {
 public:
  virtual ~HostClock() = default;
  /// The present; nothing: it does not know.
  virtual std::optional<drive::UtcTime> host_time() noexcept { return std::nullopt; }
};

}  // namespace unit
