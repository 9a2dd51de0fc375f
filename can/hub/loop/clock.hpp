#pragma once

#include "libcanopen/base/time.hpp"
#include "os/clock.hpp"

namespace hub {

/// The present on the time line of everything in the hub.
inline canopen::TimePoint monotonic_now() noexcept {
  return canopen::TimePoint{os::monotonic_time()};
}

}  // namespace hub
