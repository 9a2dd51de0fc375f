#include "motor/control/field/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/control/field/induction_circuit.hpp"
#include "motor/control/field/synchronous_observer.hpp"
#include "motor/control/signals.hpp"
#include "motor/plant/encoder.hpp"

namespace motor {
namespace {

constexpr double kDamping = 3.0;           // share of the delays in the gain: calm, not the fastest
constexpr double kIntegralDelays = 10.0;   // integral time in sums of delays
constexpr double kSensorlessDelay = 3e-3;  // s, of the speed estimate
constexpr double kObserverLags = 0.5;      // of the observer's loop at the changeover that count as delay
constexpr double kChangeover = 0.1;        // of the rated speed
constexpr double kPowerReserve = 2.0;      // p1530 does not act before twice the peak torque at rated speed
constexpr double kBoostShare = 0.5;        // p1310 of a new unit (share of the rated current's voltage drop)

SpeedControllerGains gains_for(double inertia, double delay) noexcept {
  return {.proportional = inertia / (kDamping * delay), .integral_time = kIntegralDelays * delay};
}

CurrentControllerGains current_gains(const MachineData& machine) noexcept {
  const double resistance = machine.stator_resistance;
  if (machine.type == MachineType::Synchronous) {
    const SynchronousData& data = machine.synchronous;
    return {kCurrentBandwidth * data.d_inductance, kCurrentBandwidth * data.q_inductance,
            data.d_inductance / resistance, data.q_inductance / resistance};
  }
  const InductionCircuit circuit = induction_circuit(machine);
  const double time = circuit.leakage / (resistance + circuit.rotor_resistance);
  return {kCurrentBandwidth * circuit.leakage, kCurrentBandwidth * circuit.leakage, time, time};
}

/// How late a torque comes after the speed has changed, without encoder (s).
double sensorless_delay(const MachineData& machine) noexcept {
  if (machine.type == MachineType::Induction) return kSensorlessDelay;
  const double frequency = machine.pole_pairs * kChangeover * machine.rated_speed;
  const double share = SynchronousObserver<double>::bandwidth_share(machine);
  return std::max(kSensorlessDelay, kObserverLags / SynchronousObserver<double>::bandwidth(share, frequency));
}

/// A magnet machine gets the voltage it induces, so that it takes no more current than its torque needs.
VoltageFrequencySettings voltage_frequency_of(const MachineData& machine) noexcept {
  const double drop = machine.stator_resistance * machine.rated_current * std::numbers::sqrt3;
  const bool synchronous = machine.type == MachineType::Synchronous;
  const double induced = std::sqrt(1.5) * 2.0 * std::numbers::pi * machine.rated_frequency;
  return {.rated_voltage = synchronous ? induced * machine.synchronous.magnet_flux : machine.rated_voltage,
          .rated_frequency = machine.rated_frequency,
          .boost = (synchronous ? 1.0 : kBoostShare) * drop,
          .slip_compensation = synchronous ? 0.0 : 1.0,
          .resonance_damping = 1.0};
}

}  // namespace

/// Calculation (one period), output hold and difference quotient (half a period each), torque response, speed
/// filter.
double speed_loop_delay(const MachineData& machine) noexcept {
  Encoder encoder{machine};
  encoder.configure(kControlPeriod);
  return 2.0 * kControlPeriod + 1.0 / kCurrentBandwidth + encoder.filter_time();
}

ControlSettings computed_settings(const MachineData& machine, const InverterData& inverter,
                                  double total_inertia) noexcept {
  const double power = kPowerReserve * machine.maximum_torque * machine.rated_speed;
  const double limit = std::min(machine.maximum_current, inverter.maximum_current);
  return {.speed = gains_for(total_inertia, speed_loop_delay(machine)),
          .sensorless_speed = gains_for(total_inertia, sensorless_delay(machine)),
          .current = current_gains(machine),
          .current_limit = limit,
          .motoring_power_limit = power,
          .regenerative_power_limit = -power,
          .inertia = total_inertia,
          .changeover_speed = kChangeover * machine.rated_speed,
          .start_current = std::min(machine.rated_current, limit),
          .voltage_frequency = voltage_frequency_of(machine)};
}

}  // namespace motor
