#pragma once

#include <chrono>
#include <ctime>

namespace os {

/// The present on CLOCK_MONOTONIC, since its zero.
inline std::chrono::nanoseconds monotonic_time() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
}

/// The present on CLOCK_REALTIME, since 1 January 1970, 0:00 UTC.
inline std::chrono::nanoseconds wall_time() noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  return std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec};
}

}  // namespace os
