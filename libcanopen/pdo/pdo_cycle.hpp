#pragma once

#include "libcanopen/base/time.hpp"

namespace canopen {

/// The cycle in which a device handles its process data: a grid on the time line. With a period of 0 there is
/// none, and every time counts as it is.
struct PdoCycle {
  Duration period{0};
  TimePoint origin{};  ///< where some cycle begins

  constexpr bool is_on() const noexcept { return period != Duration{0}; }
  /// The beginning of the cycle that @p time lies in.
  constexpr TimePoint begin_of(TimePoint time) const noexcept {
    if (!is_on()) return time;
    const Duration beyond = (time - origin) % period;
    return time - (beyond < Duration{0} ? beyond + period : beyond);
  }
  /// The first beginning of a cycle that is not before @p time.
  constexpr TimePoint next_from(TimePoint time) const noexcept {
    const TimePoint begin = begin_of(time);
    return begin == time ? time : begin + period;
  }
  /// @p time rounded up to whole cycles.
  constexpr Duration whole(Duration time) const noexcept {
    return is_on() ? (time + period - Duration{1}) / period * period : time;
  }
};

}  // namespace canopen
