#include "motor/control/field/induction_field.hpp"

#include <numbers>

namespace motor {
namespace {

constexpr double kFluxRate = 40.0;        // 1/s, of the flux controller
constexpr double kFluxShare = 0.8;        // of the current limit that may build up flux
constexpr double kMagnetised = 0.95;      // of the rated flux
constexpr double kSpeedRate = 300.0;      // 1/s, of the speed estimate
constexpr double kObserverDamping = 0.2;  // of the observer at speed

}  // namespace

void InductionField::configure(const MachineData& machine, const ControlSettings& settings) noexcept {
  circuit_ = induction_circuit(machine);
  pole_pairs_ = machine.pole_pairs;
  with_encoder_ = settings.mode == ControlMode::Encoder;
  torque_factor_ = 1.5 * pole_pairs_;
  current_limit_ = std::numbers::sqrt2 * settings.current_limit;
  full_flux_ = standing_flux(circuit_, std::numbers::sqrt2 * machine.induction.magnetising_current);
  set_flux_share(flux_share_);
  inductance_ = magnetising_inductance(circuit_, flux_);
  decay_ = circuit_.rotor_resistance / inductance_;
}

void InductionField::set_flux_share(double share) noexcept {
  flux_share_ = share;
  rated_flux_ = share * full_flux_;
}

void InductionField::start() noexcept {
  reserve_.reset();
  if (!with_encoder_) {
    flux_ = 0.0;
    frame_ = {};
  }
  goal_ = rated_flux_;
  current_ = {};
  setpoint_ = {};
  electrical_speed_ = 0.0;
  reachable_ = 0.0;
  magnetised_ = false;
  weakening_ = false;
}

void InductionField::start_observer(const Frame& frame, SpaceVector current) noexcept {
  frame_ = frame;
  current_ = current;
  electrical_speed_ = frame.frequency;
}

/// Voltage model whose flux along the frame is drawn to that of the current model. The gain turns the correction
/// ever more across the flux as the speed rises, which damps the observer without knowing the speed well.
Frame InductionField::observe(const Measurement& measured) noexcept {
  const SpaceVector mean = 0.5 * (measured.current + current_);
  const SpaceVector change = (circuit_.leakage / kControlPeriod) * (measured.current - current_);
  current_ = measured.current;
  const SpaceVector middle = frame_.direction * bounded_rotation(0.5 * kControlPeriod * frame_.frequency);
  const SpaceVector back = conjugate(middle);
  const SpaceVector induced = (measured.voltage - circuit_.stator_resistance * mean - change) * back;
  const SpaceVector current = mean * back;
  const double residual = circuit_.rotor_resistance * current.re - decay_ * flux_ - induced.re;
  const double speed = electrical_speed_;
  const double gain = (decay_ + 2.0 * kObserverDamping * std::abs(speed)) / (decay_ * decay_ + speed * speed);
  const SpaceVector corrected = induced + (gain * residual) * SpaceVector{decay_, speed};
  flux_ = std::max(0.0, flux_ + kControlPeriod * corrected.re);
  frame_.frequency = corrected.im / usable_flux();
  frame_.direction = turned(frame_.direction, kControlPeriod * frame_.frequency);
  electrical_speed_ += kSpeedRate * kControlPeriod * (frame_.frequency - slip(current.im) - electrical_speed_);
  return frame_;
}

SpaceVector InductionField::currents(double torque, double frequency) noexcept {
  const double across = circuit_.leakage * setpoint_.im;
  const double room = reserve_.room();
  const double needed = rated_flux_ * (1.0 + circuit_.leakage / inductance_);
  weakening_ = (needed * needed + across * across) * frequency * frequency > room * room;
  goal_ = rated_flux_;
  if (weakening_) {
    const double limit = room / frequency;
    const double along = std::sqrt(std::max(0.0, limit * limit - across * across));
    goal_ = std::clamp(along / needed, kLeastFlux, 1.0) * rated_flux_;
  }
  const double forcing = kFluxRate * (goal_ - flux_) / circuit_.rotor_resistance;
  const double most = kFluxShare * current_limit_;
  const double d = std::clamp(goal_ / inductance_ + forcing, -most, most);
  const double q_limit = std::sqrt(current_limit_ * current_limit_ - d * d);
  setpoint_ = {d, std::clamp(torque / (torque_factor_ * usable_flux()), -q_limit, q_limit)};
  return setpoint_;
}

void InductionField::trim(double dt, double demand, double highest, double frequency) noexcept {
  const double drop = circuit_.stator_resistance * std::max(0.0, std::copysign(1.0, frequency) * setpoint_.im);
  reserve_.follow(dt, demand, highest, drop, weakening_);
  inductance_ = magnetising_inductance(circuit_, flux_);
  decay_ = circuit_.rotor_resistance / inductance_;
  magnetised_ = magnetised_ || flux_ > kMagnetised * goal_;
  const double d = std::min(std::abs(goal_) / inductance_, kFluxShare * current_limit_);
  const double by_current = std::sqrt(current_limit_ * current_limit_ - d * d);
  // Breakdown: beyond it more current across takes more flux than it gives torque.
  const double fastest = std::max(std::abs(frequency), 1e-3);
  const double by_voltage = reserve_.room() / (fastest * circuit_.leakage * std::numbers::sqrt2);
  reachable_ = magnetised_ ? torque_factor_ * flux_ * std::min(by_current, by_voltage) : 0.0;
}

}  // namespace motor
