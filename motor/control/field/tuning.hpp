#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/data/inverter_data.hpp"
#include "motor/data/machine_data.hpp"

namespace motor {

/// What p0340 computes: all controllers and limits from the data of @p machine and @p inverter, for
/// @p total_inertia (kg·m², positive) at the motor shaft.
ControlSettings computed_settings(const MachineData& machine, const InverterData& inverter,
                                  double total_inertia) noexcept;

/// How late a torque comes after the speed that asked for it has changed (s), with the encoder of @p machine.
double speed_loop_delay(const MachineData& machine) noexcept;

/// Bandwidth of the current controllers (rad/s): 2π·400, as far as one and a half periods of delay allow.
inline constexpr double kCurrentBandwidth = 2513.0;

}  // namespace motor
