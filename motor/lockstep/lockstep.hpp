#pragma once

#include <cstddef>
#include <span>

#include "motor/lockstep/lane_group.hpp"
#include "motor/plant/dc_link.hpp"

namespace motor {

/// Most axes of a run.
inline constexpr std::size_t kMostAxesInLockstep = 16;

/// What came of a run.
struct RunResult {
  long periods = 0;                ///< that it made
  double lowest_dc_voltage = 0.0;  ///< at the start of one of them (V)
  double highest_dc_voltage = 0.0;
  double last_dc_voltage = 0.0;
};

/// Axes that share a DC link, in a run with those of others.
struct LinkedAxes {
  std::span<const AxisRun> axes{};
  DcLink* link = nullptr;
  double overvoltage = 0.0;  ///< above which the run ends (V)
  RunResult result{};        ///< what came of it
};

/// Advances the axes of @p units (1 to kMostAxesInLockstep, also of all axes) by up to @p periods control periods
/// (positive), and gives how many it made. The run ends early, for all, after a period that an axis whose pulses
/// are on began with its link above the overvoltage, or ended with a current above its trip_current. Axes of one
/// kind are calculated side by side, whatever their link, as @p variant can; the results are those of each by
/// itself to the last bit.
long run_together(std::span<LinkedAxes> units, long periods,
                  const LaneVariant& variant = variant_in_use()) noexcept;

/// The same with @p axes, which share @p link, alone.
RunResult run(std::span<const AxisRun> axes, DcLink& link, long periods, double overvoltage,
              const LaneVariant& variant = variant_in_use()) noexcept;

}  // namespace motor
