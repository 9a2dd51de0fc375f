#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "motor/control/measurement.hpp"
#include "motor/data/control_period.hpp"
#include "motor/identification/standstill/bench/current_lead.hpp"
#include "motor/identification/standstill/bench/shaft_watch.hpp"
#include "motor/identification/standstill/bench/standstill_data.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// A direct current between two phases.
struct DirectCurrent {
  double voltage = 0.0;  ///< that it was given (V)
  double current = 0.0;  ///< difference of both phases (A)
};

/// What the tests at standstill share: the task, what the ones before have found, the currents that they lead and
/// the shaft that they watch. A test that cannot go on says why by the fault.
struct StandstillBench {
  StandstillTask task{};
  StandstillResult result{};
  StandstillFault fault = StandstillFault::None;
  CurrentLead currents{};
  ShaftWatch shaft{};
  double test_current = 0.0;     ///< the highest that a test may lead (A peak)
  double warm_resistance = 0.0;  ///< of the stator as warm as it is (Ω)
  DirectCurrent lower_level{};   ///< of the two that give the resistance
  SpaceVector axis{1.0, 0.0};    ///< along which the currents do not turn the shaft, stator frame

  /// Lays the axis where the pole position found lies for the encoder now.
  void follow_pole(const Measurement& measured) noexcept {
    axis = measured.rotor * SpaceVector{std::cos(result.pole_position), std::sin(result.pole_position)};
  }
  /// Of rotor and load as it is believed to be, not less than the rotor's own (kg·m²).
  double believed_inertia() const noexcept { return std::max(task.machine.inertia, task.settings.inertia); }
};

/// Control periods in @p seconds.
constexpr int steps_in(double seconds) noexcept {
  return static_cast<int>((seconds + 0.5 * kControlPeriod) / kControlPeriod);
}

/// Signs of the currents in the phases.
constexpr std::array<double, 3> phase_signs(SpaceVector current) noexcept {
  std::array<double, 3> phases = phase_values(current);
  for (double& phase : phases) phase = phase > 0.0 ? 1.0 : -1.0;
  return phases;
}

}  // namespace motor
