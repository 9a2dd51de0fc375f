#pragma once

#include <chrono>
#include <ctime>

#include "libcanopen/base/time.hpp"

namespace hub {

/// CLOCK_MONOTONIC: the time line of everything in the hub.
inline canopen::TimePoint monotonic_now() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return canopen::TimePoint{std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec}};
}

}  // namespace hub
