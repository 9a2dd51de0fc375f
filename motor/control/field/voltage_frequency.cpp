#include "motor/control/field/voltage_frequency.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/control/field/voltage_reserve.hpp"

namespace motor {
namespace {

constexpr double kTorqueTime = 0.05;        // s, of the torque estimate
constexpr double kSwingTime = 0.05;         // s, slower changes of the current are no resonance
constexpr double kSlowShare = 0.05;         // of the rated frequency, below it the torque is not to be seen
constexpr double kInductionDamping = 0.02;  // of the rated frequency at rated current
constexpr double kLargestSwing = 0.05;      // of the rated frequency
constexpr double kVirtualResistance = 3.0;  // of the stator's: what the I_max controller takes off the voltage
constexpr double kVdcBand = 20.0;           // V, over which the frequency is held
constexpr double kRamping = 1.0;            // rad/s², from where on the acceleration boost counts

/// Gain that damps a magnet rotor which swings about the voltage to about one half.
double synchronous_damping(const MachineData& machine, double inertia) noexcept {
  const SynchronousData& data = machine.synchronous;
  const double by_current = 1.5 * machine.pole_pairs * data.magnet_flux;
  const double stiffness = by_current * data.magnet_flux / data.d_inductance;
  return std::sqrt(stiffness * machine.pole_pairs / inertia) / stiffness * by_current;
}

}  // namespace

void VoltageFrequencyControl::configure(const MachineData& machine, const ControlSettings& settings) noexcept {
  settings_ = settings.voltage_frequency;
  pole_pairs_ = machine.pole_pairs;
  resistance_ = machine.stator_resistance;
  rated_frequency_ = 2.0 * std::numbers::pi * settings_.rated_frequency;
  current_limit_ = std::numbers::sqrt2 * settings.current_limit;
  vdc_max_ = settings.vdc_max;
  reduction_rate_ = settings_.frequency_reduction * rated_frequency_ / current_limit_;
  if (machine.type == MachineType::Synchronous) {
    slip_rate_ = 0.0;
    damping_gain_ = settings_.resonance_damping * synchronous_damping(machine, settings.inertia);
    return;
  }
  const double slip = rated_frequency_ - pole_pairs_ * machine.rated_speed;
  slip_rate_ = std::max(0.0, slip) / machine.rated_torque;
  damping_gain_ = settings_.resonance_damping * kInductionDamping * rated_frequency_ /
                  (std::numbers::sqrt2 * machine.rated_current);
}

void VoltageFrequencyControl::start() noexcept {
  frame_ = {};
  torque_ = 0.0;
  active_current_ = 0.0;
  swing_ = 0.0;
  excess_ = 0.0;
  reduction_ = 0.0;
}

/// What the currents show; @p current is along and across the voltage.
void VoltageFrequencyControl::watch(const Measurement& measured, SpaceVector current) noexcept {
  const double across_gap = 1.5 * (dot(measured.voltage, measured.current) - resistance_ * norm(measured.current));
  const double slowest = kSlowShare * rated_frequency_;
  const double turning = std::copysign(std::max(std::abs(frame_.frequency), slowest), frame_.frequency);
  torque_ += kControlPeriod / kTorqueTime * (pole_pairs_ * across_gap / turning - torque_);
  active_current_ += kControlPeriod / kSwingTime * (current.re - active_current_);
  swing_ = current.re - active_current_;
  excess_ = length(current) - current_limit_;
  if (excess_ > 0.0)
    reduction_ += std::copysign(reduction_rate_ * kControlPeriod * excess_, active_current_);
  else
    reduction_ -=
        std::copysign(std::min(std::abs(reduction_), -reduction_rate_ * kControlPeriod * excess_), reduction_);
  reduction_ = std::clamp(reduction_, -rated_frequency_, rated_frequency_);
}

double VoltageFrequencyControl::frequency_for(const DriveCommand& command, double dc_voltage) const noexcept {
  const double slip = settings_.slip_compensation * slip_rate_ * torque_;
  const double largest = kLargestSwing * rated_frequency_;
  const double damping = std::clamp(damping_gain_ * swing_, -largest, largest);
  const double direction = std::copysign(1.0, command.speed_setpoint);
  const double wanted = pole_pairs_ * std::abs(command.speed_setpoint) + direction * slip;
  const double frequency = direction * std::max(0.0, wanted - reduction_ - damping);
  if (vdc_max_ <= 0.0 || dc_voltage < vdc_max_ - kVdcBand || std::abs(frequency) > std::abs(frame_.frequency))
    return frequency;
  const double share = std::clamp((vdc_max_ - dc_voltage) / kVdcBand, 0.0, 1.0);
  return frame_.frequency + share * (frequency - frame_.frequency);
}

/// Voltage (V peak of a phase) at @p frequency (electrical rad/s).
double VoltageFrequencyControl::amplitude_for(double frequency, double acceleration) const noexcept {
  const double share = std::min(1.0, std::abs(frequency) / rated_frequency_);
  const double ramping = std::abs(acceleration) > kRamping ? settings_.acceleration_boost : 0.0;
  const double line = (settings_.parabolic ? share * share : share) * settings_.rated_voltage +
                      (1.0 - share) * (settings_.boost + ramping);
  constexpr double kPhasePeak = 0.81649658092772603;  // sqrt(2/3)
  return std::max(0.0, kPhasePeak * line - kVirtualResistance * resistance_ * std::max(0.0, excess_));
}

SpaceVector VoltageFrequencyControl::step(const Measurement& measured, const DriveCommand& command,
                                          Signals& signals) noexcept {
  const SpaceVector current = measured.current * conjugate(frame_.direction);
  watch(measured, current);
  frame_.frequency = frequency_for(command, measured.dc_voltage);
  frame_.direction = turned(frame_.direction, kControlPeriod * frame_.frequency);
  const double wanted = amplitude_for(frame_.frequency, command.acceleration_setpoint);
  const double amplitude = std::min(wanted, VoltageReserve::highest(measured.dc_voltage));
  signals.voltage_limited = amplitude < wanted;
  signals.torque_limits = command.limits;
  report(current, signals);
  return amplitude * frame_.direction;
}

void VoltageFrequencyControl::report(SpaceVector current, Signals& signals) const noexcept {
  signals.measured_speed = (frame_.frequency - slip_rate_ * torque_) / pole_pairs_;
  signals.torque = torque_;
  signals.torque_setpoint = torque_;
  signals.torque_limit_reached = excess_ > 0.0 || std::abs(reduction_) > 0.0;
  signals.d_current = -current.im;
  signals.q_current = current.re;
  signals.d_current_setpoint = signals.d_current;
  signals.q_current_setpoint = signals.q_current;
  signals.frequency = frame_.frequency;
  signals.magnetised = true;
}

}  // namespace motor
