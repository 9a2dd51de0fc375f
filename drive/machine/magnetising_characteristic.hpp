#pragma once

#include <array>

#include "motor/data/machine_data.hpp"

namespace drive {

/// The magnetising characteristic of an induction machine, p0362 to p0369: rotor flux and the current that it
/// takes, as shares of the flux and the current (p0320) at the rating point.
struct MagnetisingCharacteristic {
  std::array<double, 4> flux{};
  std::array<double, 4> current{};
};

/// The characteristic of @p machine at 60, 85, 115 and 125 % of the rated flux; a straight line where nothing
/// saturates.
MagnetisingCharacteristic characteristic_of(const motor::MachineData& machine) noexcept;

/// Rotor flux (V·s) at which saturation has halved the magnetising inductance of @p machine, 0 = no saturation:
/// the one whose curve through the rating point comes closest to @p characteristic by least squares of the
/// currents.
double saturation_flux(const motor::MachineData& machine,
                       const MagnetisingCharacteristic& characteristic) noexcept;

}  // namespace drive
