#pragma once

#include "motor/identification/rotating/rotating_task.hpp"

namespace motor {

/// The speeds at which a rotating measurement looks at a machine (rad/s, positive).
struct TestSpeeds {
  double low = 0.0;       ///< of the first turns
  double moderate = 0.0;  ///< fast enough to see the induced voltage
  double least = 0.0;     ///< from here up a ramp is looked at
  double high = 0.0;      ///< the end of a ramp

  /// Whether they can be told apart.
  bool useful() const noexcept { return low > 0.0 && high > 1.5 * least; }
};

/// For @p task at @p dc_voltage (V) with up to @p flux_share of the rated flux: 40 % of the rated speed, less
/// where limits of speed or voltage ask for it.
TestSpeeds test_speeds(const RotatingTask& task, double dc_voltage, double flux_share = 1.0) noexcept;

/// Sign of the first turns: backwards only where nothing else is allowed.
constexpr double first_direction(const RotatingTask& task) noexcept {
  return task.forward ? 1.0 : -1.0;
}

/// Slope of the speed setpoint (rad/s²) before anything is known of the load.
double cautious_slope(const RotatingTask& task) noexcept;
/// The slope that p1958 allows (rad/s²).
double allowed_slope(const RotatingTask& task) noexcept;
/// Torque limits of a measurement: those of @p task, and the rated torque (N·m).
TorqueLimits test_limits(const RotatingTask& task) noexcept;

}  // namespace motor
