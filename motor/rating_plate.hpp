#pragma once

#include "motor/machine_data.hpp"

namespace motor {

/// The equivalent circuit of an induction machine from its rating plate (p0304, p0305, p0307, p0308, p0310,
/// p0311), as p0340 = 1 or 2 computes it: @p machine with stator resistance, rotor resistance, leakages,
/// magnetising inductance and magnetising current replaced. At rated slip the circuit gives the rated torque and
/// takes the reactive power of the plate; what a plate does not say (losses of the stator, breakdown torque) is
/// taken as usual for standard machines.
MachineData circuit_from_plate(const MachineData& machine) noexcept;

}  // namespace motor
