#include "motor/identification/rotating/test_speeds.hpp"

#include <algorithm>

#include "motor/control/field/voltage_reserve.hpp"
#include "motor/identification/model/field_model.hpp"

namespace motor {
namespace {

constexpr double kHigh = 0.4;            // of the rated speed
constexpr double kBelowMaximum = 0.85;   // of the maximum speed: a controller may overshoot
constexpr double kVoltageShare = 0.6;    // of the highest voltage: the flux may be more than is believed
constexpr double kLeast = 0.3;           // of the high speed
constexpr double kModerate = 0.5;        // of the high speed
constexpr double kLow = 0.15;            // of the high speed
constexpr double kUseful = 0.08;         // of the rated speed, that the high one must have
constexpr double kObserved = 1.6;        // of the changeover speed, where an observer sees
constexpr double kClearly = 1.5;         // of the slowest speed that an observer sees
constexpr double kCautiousSlope = 0.5;   // rated speeds a second
constexpr double kCautiousTorque = 0.3;  // of the rated one
constexpr double kHeavyLoad = 7.0;       // inertias of the rotor, rotor and load together
constexpr double kUnlimited = 1e9;       // rad/s²

}  // namespace

TestSpeeds test_speeds(const RotatingTask& task, double dc_voltage, double flux_share) noexcept {
  const MachineData& machine = task.machine;
  const double flux = flux_share * rated_flux(machine);
  const double by_voltage =
      kVoltageShare * VoltageReserve<double>::highest(dc_voltage) / (machine.pole_pairs * flux);
  const double high = std::min({kHigh * machine.rated_speed, kBelowMaximum * task.maximum_speed, by_voltage});
  if (high < kUseful * machine.rated_speed) return {};
  const bool observed = task.settings.mode == ControlMode::Sensorless;
  const double seen = observed ? kObserved * task.settings.changeover_speed : 0.0;
  return {.low = std::max(kLow * high, seen),
          .moderate = std::max(kModerate * high, kClearly * seen),
          .least = std::max(kLeast * high, seen),
          .high = high};
}

double allowed_slope(const RotatingTask& task) noexcept {
  return task.ramp_time > 0.0 ? task.maximum_speed / task.ramp_time : kUnlimited;
}

double cautious_slope(const RotatingTask& task) noexcept {
  const double inertia = std::max(kHeavyLoad * task.machine.inertia, task.settings.inertia);
  return std::min({kCautiousSlope * task.machine.rated_speed,
                   kCautiousTorque * task.machine.rated_torque / inertia, allowed_slope(task)});
}

TorqueLimits test_limits(const RotatingTask& task) noexcept {
  const double rated = task.machine.rated_torque;
  return {std::min(task.torque_limits.upper, rated), std::max(task.torque_limits.lower, -rated)};
}

}  // namespace motor
