#pragma once

#include <cmath>
#include <numbers>

#include "motor/control/field/induction_circuit.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// Inductances along and across the field whose flux is not that of the magnets or of the rotor (H).
constexpr SpaceVector current_inductances(const MachineData& machine) noexcept {
  if (machine.type == MachineType::Synchronous)
    return {machine.synchronous.d_inductance, machine.synchronous.q_inductance};
  const double leakage = induction_circuit(machine).leakage;
  return {leakage, leakage};
}

/// Flux of @p current (A) in @p inductances (H) (V·s).
constexpr SpaceVector flux_of(SpaceVector inductances, SpaceVector current) noexcept {
  return {inductances.re * current.re, inductances.im * current.im};
}

/// Flux that induces @p voltage (V) where it turns steadily at @p frequency (electrical rad/s, not 0) (V·s).
constexpr SpaceVector inducing_flux(SpaceVector voltage, double frequency) noexcept {
  return (1.0 / frequency) * SpaceVector{voltage.im, -voltage.re};
}

/// Flux that is believed to induce the voltage: of the magnets, or of the rotor at @p current (A) along it (V·s).
inline double believed_flux(const MachineData& machine, double current) noexcept {
  if (machine.type == MachineType::Synchronous) return machine.synchronous.magnet_flux;
  return standing_flux(induction_circuit(machine), current);
}
/// The same at rated magnetising current (V·s).
inline double rated_flux(const MachineData& machine) noexcept {
  return believed_flux(machine, std::numbers::sqrt2 * machine.induction.magnetising_current);
}

}  // namespace motor
