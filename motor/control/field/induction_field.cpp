#include "motor/control/field/induction_field.hpp"

#include <numbers>

namespace motor {

template <>
void InductionField<double>::configure(const MachineData& machine, const ControlSettings& settings) noexcept {
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

template <>
void InductionField<double>::set_flux_share(double share) noexcept {
  flux_share_ = share;
  rated_flux_ = share * full_flux_;
}

template <>
void InductionField<double>::start() noexcept {
  reserve_.reset();
  if (!with_encoder_.holds()) {
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

}  // namespace motor
