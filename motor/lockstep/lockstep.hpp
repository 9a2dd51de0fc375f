#pragma once

#include <cstddef>
#include <span>

#include "motor/lockstep/lane_group.hpp"
#include "motor/plant/dc_link.hpp"

namespace motor {

/// Most axes of a run.
inline constexpr std::size_t kMostAxesInLockstep = 8;

/// What came of a run.
struct RunResult {
  long periods = 0;                ///< that it made
  double lowest_dc_voltage = 0.0;  ///< at the start of one of them (V)
  double highest_dc_voltage = 0.0;
  double last_dc_voltage = 0.0;
};

/// Advances @p axes (at most kMostAxesInLockstep), which share @p link, by up to @p periods control periods
/// (positive). The run ends early after a period that an axis whose pulses are on began with the link above @p
/// overvoltage (V), or ended with a current above its trip_current. Axes of one kind are calculated side by side,
/// as @p variant can; the results are those of each by itself to the last bit.
RunResult run(std::span<const AxisRun> axes, DcLink& link, long periods, double overvoltage,
              const LaneVariant& variant = widest_variant()) noexcept;

}  // namespace motor
