#pragma once

#include "motor/data/machine_data.hpp"
#include "motor/math/crossing.hpp"
#include "motor/math/number.hpp"

namespace motor {

/// An induction machine as inverse-gamma circuit: the T circuit with its superfluous leakage removed, alike at the
/// terminals.
template <class Number>
struct InductionCircuitOf {
  Number stator_resistance = 1.0;       ///< (Ω)
  Number rotor_resistance = 1.0;        ///< R_R (Ω)
  Number leakage = 1e-3;                ///< L_sgm (H)
  Number magnetising_inductance = 0.1;  ///< L_M without saturation (H)
  Number saturation_flux = 0.0;         ///< at which L_M has halved (V·s), 0 = none
};
using InductionCircuit = InductionCircuitOf<double>;

/// The circuit of @p machine at kDataTemperature.
constexpr InductionCircuit induction_circuit(const MachineData& machine) noexcept {
  const InductionData& data = machine.induction;
  const double k = data.magnetising_inductance / (data.magnetising_inductance + data.rotor_leakage);
  return {machine.stator_resistance, k * k * data.rotor_resistance, data.stator_leakage + k * data.rotor_leakage,
          k * data.magnetising_inductance, data.saturation_flux};
}

/// Magnetising inductance (H) at rotor flux @p flux (V·s).
template <class Number>
Number magnetising_inductance(const InductionCircuitOf<Number>& circuit, const Number& flux) noexcept {
  const Condition<Number> linear = circuit.saturation_flux <= 0.0;
  if (all(linear)) return circuit.magnetising_inductance;
  const Number ratio = flux / circuit.saturation_flux;
  const Number cube = ratio * ratio * ratio;
  return select<Number>(linear, circuit.magnetising_inductance,
                        circuit.magnetising_inductance / (1.0 + cube * cube));
}

/// Rotor flux (V·s) at which @p current (A peak) along it lets it stand.
inline double standing_flux(const InductionCircuit& circuit, double current) noexcept {
  return crossing(0.0, circuit.magnetising_inductance * current,
                  [&](double flux) { return flux - magnetising_inductance(circuit, flux) * current; });
}

}  // namespace motor
