#pragma once

#include "libcanopen/base/time.hpp"
#include "os/clock.hpp"

namespace axisd {

/// The present on the time line that everything below is told.
inline canopen::TimePoint read_clock() noexcept {
  return canopen::TimePoint{os::monotonic_time()};
}

}  // namespace axisd
