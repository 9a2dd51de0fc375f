#pragma once

#include <chrono>
#include <cstdint>

namespace canopen {

/// Resolution of every time in the library: 1 ns.
using Duration = std::chrono::nanoseconds;

/// Tag of the time line that the owner of a node tells; the library never reads a clock.
struct ToldClock {
  // NOLINTBEGIN(readability-identifier-naming): the names that <chrono> asks of a clock
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<ToldClock, Duration>;
  static constexpr bool is_steady = true;
  // NOLINTEND(readability-identifier-naming)
};

/// A point on the monotonic time line of the owner (on Linux: CLOCK_MONOTONIC).
using TimePoint = ToldClock::time_point;

/// An inhibit time as CiA 301 gives it, in units of 100 us (objects 1015h and 1800h:03).
constexpr Duration inhibit_time(std::int64_t units) noexcept {
  return std::chrono::microseconds{100 * units};
}

/// "Never": later than every deadline.
inline constexpr TimePoint kNever = TimePoint::max();

}  // namespace canopen
