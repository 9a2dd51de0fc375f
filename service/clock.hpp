#pragma once

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
  return when == canopen::kNever ? -1 : os::poll_limit(when - read_clock());
}

}  // namespace axisd
