#pragma once

#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"

namespace motor {

/// Largest product of a step and an electrical rate: there the classical Runge-Kutta step is still exact to 1e-4.
inline constexpr double kElectricalStep = 0.6;
/// The same of mechanical oscillations, which last longer and would lose energy to the method.
inline constexpr double kMechanicalStep = 0.3;

/// How many steps in a control period @p machine and @p load need, at least 1.
int needed_substeps(const MachineData& machine, const Load& load) noexcept;

}  // namespace motor
