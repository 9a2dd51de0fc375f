#pragma once

#include <algorithm>
#include <chrono>

#include "libcanopen/base/time.hpp"
#include "os/clock.hpp"

namespace axisd {

/// The present on the time line that everything below is told.
inline canopen::TimePoint read_clock() noexcept {
  return canopen::TimePoint{os::monotonic_time()};
}

/// The present of the machine, whatever clock the process lives by.
inline canopen::TimePoint machine_clock() noexcept {
  return canopen::TimePoint{os::machine_time(CLOCK_MONOTONIC)};
}

/// From now until @p when, at most an hour, rounded up, for poll(2): negative = for ever.
inline int milliseconds_until(canopen::TimePoint when) noexcept {
  constexpr canopen::Duration kLongest = std::chrono::hours{1};
  if (when == canopen::kNever) return -1;
  const canopen::Duration left = std::clamp(when - read_clock(), canopen::Duration{0}, kLongest);
  return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(left).count());
}

}  // namespace axisd
