#pragma once

#include <ctime>

#include "libcanopen/base/time.hpp"

namespace axisd {

/// The present on the time line that everything below is told: CLOCK_MONOTONIC.
inline canopen::TimePoint read_clock() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return canopen::TimePoint{std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec}};
}

}  // namespace axisd
