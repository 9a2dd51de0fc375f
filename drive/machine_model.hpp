#pragma once

#include <cstdint>

#include "drive/parameters.hpp"
#include "motor/data/machine_data.hpp"

namespace drive {

/// The machine as @p parameters describe it to the control: @p machine with p0304 to p0360 in place of its own
/// data.
motor::MachineData believed_machine(const AxisParameters& parameters, const motor::MachineData& machine) noexcept;

/// Torque constant (N·m/A rms) of a synchronous machine like @p data_sheet whose magnets have the flux @p
/// magnet_flux (V·s).
constexpr double torque_constant(const motor::MachineData& data_sheet, double magnet_flux) noexcept {
  return data_sheet.torque_constant * magnet_flux / data_sheet.synchronous.magnet_flux;
}

/// The first motor parameter whose value cannot be that of @p machine's kind, such as a resistance of 0; 0 if all
/// can. It is the value of F07950.
std::uint16_t implausible_motor_parameter(const AxisParameters& parameters,
                                          const motor::MachineData& machine) noexcept;

/// p0300 of @p type.
constexpr std::int32_t motor_type_number(motor::MachineType type) noexcept {
  return type == motor::MachineType::Induction ? 1 : 2;
}

/// Whether p0300 and p0301 of @p parameters are those of a motor of the list (a number of its series or a code),
/// whose data the unit knows; otherwise only its rating plate is known.
bool is_listed_motor(const AxisParameters& parameters) noexcept;

}  // namespace drive
