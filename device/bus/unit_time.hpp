#pragma once

#include "libcanopen/base/time.hpp"
#include "unit/time.hpp"

namespace device {

/// A point on the time line of the node as one on that of the unit: both are what the program around tells.
constexpr unit::TimePoint unit_time(canopen::TimePoint time) noexcept {
  return unit::TimePoint{time.time_since_epoch()};
}
/// The same the other way; never stays never.
constexpr canopen::TimePoint node_time(unit::TimePoint time) noexcept {
  return canopen::TimePoint{time.time_since_epoch()};
}
static_assert(unit_time(canopen::kNever) == unit::kNever);

}  // namespace device
