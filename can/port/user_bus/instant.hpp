#pragma once

#include <cstdint>

#include "can/userbus/time.hpp"
#include "libcanopen/base/time.hpp"

namespace bus {

/// An instant of the bus's time as its messages have it (ns), userbus::kNoInstant for kNever.
constexpr std::int64_t to_ns(canopen::TimePoint time) noexcept {
  return time == canopen::kNever ? userbus::kNoInstant : time.time_since_epoch().count();
}

/// The other way round.
constexpr canopen::TimePoint from_ns(std::int64_t time_ns) noexcept {
  return time_ns == userbus::kNoInstant ? canopen::kNever : canopen::TimePoint{canopen::Duration{time_ns}};
}

}  // namespace bus
