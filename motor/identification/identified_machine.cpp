#include <cmath>

#include "motor/control/field/induction_circuit.hpp"
#include "motor/identification/standstill/standstill_measurement.hpp"

namespace motor {
namespace {

/// The part k of L_m that is magnetising inductance of the inverse-Gamma circuit, so that leakages in the ratio
/// @p ratio (stator to rotor) give its leakage: k² (L_sgm + L_M) + k L_M (ratio - 1) - L_M ratio = 0.
double coupling(double leakage, double magnetising, double ratio) noexcept {
  const double a = leakage + magnetising;
  const double b = magnetising * (ratio - 1.0);
  return (-b + std::sqrt(b * b + 4.0 * a * magnetising * ratio)) / (2.0 * a);
}

}  // namespace

MachineData identified_machine(const MachineData& believed, const StandstillResult& result) noexcept {
  MachineData found = believed;
  found.stator_resistance = result.stator_resistance;
  if (believed.type == MachineType::Synchronous) {
    found.synchronous.d_inductance = result.d_inductance;
    found.synchronous.q_inductance = result.q_inductance;
    return found;
  }
  const double ratio = believed.induction.stator_leakage / believed.induction.rotor_leakage;
  const double k = coupling(result.leakage, result.magnetising_inductance, ratio);
  InductionData& circuit = found.induction;
  circuit.magnetising_inductance = result.magnetising_inductance / k;
  circuit.rotor_leakage = circuit.magnetising_inductance * (1.0 - k) / k;
  circuit.stator_leakage = ratio * circuit.rotor_leakage;
  circuit.rotor_resistance = result.rotor_resistance / (k * k);
  return found;
}

}  // namespace motor
