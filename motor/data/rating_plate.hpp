#pragma once

#include "motor/data/machine_data.hpp"

namespace motor {

/// The equivalent circuit of an induction machine from its rating plate (p0304, p0305, p0307, p0308, p0310,
/// p0311), as p0340 = 1 or 2 computes it: @p machine with stator resistance, rotor resistance, leakages,
/// magnetising inductance and magnetising current replaced. At rated slip the circuit gives the rated torque and
/// takes the reactive power of the plate; what a plate does not say (losses of the stator, breakdown torque) is
/// taken as usual for standard machines.
MachineData circuit_from_plate(const MachineData& machine) noexcept;

/// The same of a synchronous machine, from p0304, p0310 and p0323: @p machine with stator resistance and
/// inductances replaced, whose ratio stays. Its plate says nothing of them; they are those of a usual servo motor,
/// in which the rated voltage at the rated frequency drives the maximum current through the inductance. A plate
/// with a 0 among the three changes nothing.
MachineData magnetic_data_from_plate(const MachineData& machine) noexcept;

/// Moment of inertia of the rotor of a usual motor with the rated power and speed of @p machine (kg·m²); its own
/// if one of them is 0.
double inertia_from_plate(const MachineData& machine) noexcept;

}  // namespace motor
