#include "drive/machine/magnetising_characteristic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "motor/control/field/induction_circuit.hpp"

// With saturation the flux psi takes the current psi/L_M·(1 + (psi/psi_sat)^6). In shares f and c of the flux and
// the current at the rating point that is c = f + b·(f^7 - f), where b = a/(1 + a) and a = (rated flux/psi_sat)^6.
namespace drive {
namespace {

constexpr std::array kFluxShares{0.60, 0.85, 1.15, 1.25};  // p0362 to p0365 of a new unit
constexpr double kHighestShare = 0.95;                     // of saturation in the rated current
constexpr double kLeastShare = 1e-6;                       // what rounding can feign

double bend(double flux) noexcept {
  return std::pow(flux, 7) - flux;
}

double rated_current(const motor::MachineData& machine) noexcept {
  return std::numbers::sqrt2 * machine.induction.magnetising_current;
}

}  // namespace

MagnetisingCharacteristic characteristic_of(const motor::MachineData& machine) noexcept {
  const motor::InductionCircuit circuit = motor::induction_circuit(machine);
  const double rated_flux = motor::standing_flux(circuit, rated_current(machine));
  const double saturation =
      circuit.saturation_flux > 0.0 ? std::pow(rated_flux / circuit.saturation_flux, 6) : 0.0;
  const double share = std::min(saturation / (1.0 + saturation), kHighestShare);
  MagnetisingCharacteristic characteristic{.flux = kFluxShares};
  std::ranges::transform(kFluxShares, characteristic.current.begin(),
                         [=](double flux) { return flux + share * bend(flux); });
  return characteristic;
}

double saturation_flux(const motor::MachineData& machine,
                       const MagnetisingCharacteristic& characteristic) noexcept {
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < characteristic.flux.size(); ++i) {
    const double bent = bend(characteristic.flux[i]);
    product += bent * (characteristic.current[i] - characteristic.flux[i]);
    square += bent * bent;
  }
  const double share = square > 0.0 ? std::min(product / square, kHighestShare) : 0.0;
  if (share < kLeastShare) return 0.0;
  const double rated_flux =
      motor::induction_circuit(machine).magnetising_inductance * rated_current(machine) * (1.0 - share);
  return rated_flux * std::pow((1.0 - share) / share, 1.0 / 6.0);
}

}  // namespace drive
