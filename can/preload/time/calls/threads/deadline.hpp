#pragma once

#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/instant.hpp"

namespace preload {

/// When @p clock of the bus shows @p time, as the bus's CLOCK_MONOTONIC; nullptr: never.
inline int64_t deadline_of(clockid_t clock, const timespec* time) noexcept {
  int64_t offset = 0;
  if (time == nullptr) return kNoInstant;
  const int64_t ns = ns_of(*time);
  return is_of_bus(clock, offset) && ns != kNoInstant ? ns - offset : ns;
}

/// The same as the machine's CLOCK_MONOTONIC shows it.
inline timespec machine_time_of(clockid_t clock, const timespec* time) noexcept {
  return timespec_of(machine_instant(deadline_of(clock, time)));
}

}  // namespace preload
