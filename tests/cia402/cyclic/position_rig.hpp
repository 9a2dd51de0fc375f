#pragma once

#include "cia402/modes/cyclic/cyclic_position.hpp"
#include "tests/cia402/cyclic/timeline.hpp"

namespace cia402 {

inline constexpr std::uint16_t kEnabled = 0x000F;
inline constexpr std::uint16_t kHalted = 0x010F;

/// csp at rest at 0 with T = 10 ms, without supervision and limits that are met.
struct PositionRig {
  CyclicSettings settings{.period = 10ms, .deceleration = 1e6, .quick_stop_deceleration = 2e6};
  Limits limits{.velocity = 1e9, .acceleration = 1e9, .deceleration = 1e9};
  CyclicPosition mode;
  Timeline timeline{[this] { return mode.cycle(settings, limits); }};

  PositionRig() { mode.enter({}, kEnabled); }

  void set_point(double position, TimeNs time, const Offsets& offsets = {}) {
    mode.set_point(position, offsets, timeline.instant(time), settings, limits);
  }
  /// Runs to @p time and tells the position demand there.
  double position_at(TimeNs time) {
    timeline.run_to(time);
    return timeline.demand_at(time).motion.position;
  }
  double velocity_at(TimeNs time) {
    timeline.run_to(time);
    return timeline.demand_at(time).motion.velocity;
  }
  bool follows() const { return mode.bits(false).bit_12; }
  bool is_limited() const { return mode.demand().is_limited; }
};

}  // namespace cia402
