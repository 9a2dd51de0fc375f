#pragma once

#include "cia402/modes/cyclic/set_point_clock.hpp"

namespace cia402 {

/// The straight line on which a demand runs to a set-point, by the clock of its set-point.
struct SetPointLine {
  double from = 0.0;
  double to = 0.0;

  /// By second.
  double slope(const SetPointClock& clock) const noexcept { return (to - from) / seconds(clock.period()); }
  /// The value @p ahead of the time of @p clock, with the same slope behind the end too.
  double at(const SetPointClock& clock, TimeNs ahead) const noexcept {
    const TimeNs beyond = clock.elapsed() + ahead - clock.period();
    return to + (to - from) * (seconds(beyond) / seconds(clock.period()));
  }
};

}  // namespace cia402
