#include "motor/plant/machine/induction_machine.hpp"

#include "motor/plant/machine/temperature.hpp"

namespace motor {
namespace {

/// Square of a rotor flux that is taken for gone (V²·s²).
constexpr double kNoFlux = 1e-14;

double per_sixth_power(double flux) noexcept {
  return flux > 0.0 ? 1.0 / (flux * flux * flux * flux * flux * flux) : 0.0;
}

}  // namespace

InductionMachine::InductionMachine(const MachineData& machine) noexcept
    : cold_stator_resistance_{machine.stator_resistance} {
  pole_pairs_ = static_cast<double>(machine.pole_pairs);
  signed_pole_pairs_ = Pair{-pole_pairs_, pole_pairs_};
  torque_factor_ = 1.5 * pole_pairs_;
  saturation_ = per_sixth_power(machine.induction.saturation_flux);
  const InductionData& t = machine.induction;
  const double k = t.magnetising_inductance / (t.magnetising_inductance + t.rotor_leakage);
  inverse_leakage_ = 1.0 / (t.stator_leakage + k * t.rotor_leakage);
  reluctance_ = 1.0 / (k * t.magnetising_inductance);
  cold_rotor_resistance_ = k * k * t.rotor_resistance;
  set_temperatures(kDataTemperature, kDataTemperature);
}

void InductionMachine::set_temperatures(double winding, double rotor) noexcept {
  stator_resistance_ = cold_stator_resistance_ * resistance_factor(winding);
  rotor_resistance_ = cold_rotor_resistance_ * resistance_factor(rotor);
}

double InductionMachine::cut() noexcept {
  const double before = stored();
  if (dot(state_.rotor, state_.rotor) < kNoFlux) state_.rotor = Pair{};
  state_.stator = state_.rotor;
  return before - stored();
}

double InductionMachine::stored() const noexcept {
  const double square = dot(state_.rotor, state_.rotor);
  const Pair beside = state_.stator - state_.rotor;
  const double leakage = dot(beside, beside) * inverse_leakage_;
  const double main = reluctance_ * square * (1.0 + 0.25 * saturation_ * square * square * square);
  return 1.5 * 0.5 * (leakage + main);
}

InductionMachine::Rate InductionMachine::blocked_rate(const CircuitState& y, double w) const noexcept {
  const Pair slip = reluctance(dot(y.rotor, y.rotor)) * y.rotor;
  const Pair fading = turned(y.rotor, w) - rotor_resistance_ * slip;
  return {fading, fading, Pair{}, Pair{}, slip * slip, 0.0};
}

}  // namespace motor
