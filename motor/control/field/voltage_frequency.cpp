#include "motor/control/field/voltage_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kInductionDamping = 0.02;  // of the rated frequency at rated current

/// Gain that damps a magnet rotor which swings about the voltage to about one half.
double synchronous_damping(const MachineData& machine, double inertia) noexcept {
  const SynchronousData& data = machine.synchronous;
  const double by_current = 1.5 * machine.pole_pairs * data.magnet_flux;
  const double stiffness = by_current * data.magnet_flux / data.d_inductance;
  return std::sqrt(stiffness * machine.pole_pairs / inertia) / stiffness * by_current;
}

}  // namespace

template <>
void VoltageFrequencyControl<double>::configure(const MachineData& machine,
                                                const ControlSettings& settings) noexcept {
  const VoltageFrequencySettings& curve = settings.voltage_frequency;
  rated_voltage_ = curve.rated_voltage;
  boost_ = curve.boost;
  acceleration_boost_ = curve.acceleration_boost;
  parabolic_ = curve.parabolic;
  slip_compensation_ = curve.slip_compensation;
  pole_pairs_ = machine.pole_pairs;
  resistance_ = machine.stator_resistance;
  rated_frequency_ = 2.0 * std::numbers::pi * curve.rated_frequency;
  current_limit_ = std::numbers::sqrt2 * settings.current_limit;
  vdc_max_ = settings.vdc_max;
  reduction_rate_ = curve.frequency_reduction * rated_frequency_ / current_limit_;
  if (machine.type == MachineType::Synchronous) {
    slip_rate_ = 0.0;
    damping_gain_ = curve.resonance_damping * synchronous_damping(machine, settings.inertia);
    return;
  }
  const double slip = rated_frequency_ - pole_pairs_ * machine.rated_speed;
  slip_rate_ = std::max(0.0, slip) / machine.rated_torque;
  damping_gain_ = curve.resonance_damping * kInductionDamping * rated_frequency_ /
                  (std::numbers::sqrt2 * machine.rated_current);
}

template <>
void VoltageFrequencyControl<double>::start() noexcept {
  frame_ = {};
  torque_ = 0.0;
  active_current_ = 0.0;
  swing_ = 0.0;
  excess_ = 0.0;
  reduction_ = 0.0;
}

}  // namespace motor
