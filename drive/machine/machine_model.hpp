#pragma once

#include <cstdint>

#include "motor/data/machine_data.hpp"

namespace drive {

class MotorModel;

/// What the control believes of the machine (p03xx), in SI units; the machine itself stays what it is.
struct MotorData {
  using Block = MotorModel;

  std::int32_t motor_type = 0;         ///< p0300: 1 induction, 2 synchronous
  std::int32_t motor_code = 0;         ///< p0301, not 0 = a motor of the list
  double rated_voltage = 0.0;          ///< p0304 (V rms)
  double rated_current = 0.0;          ///< p0305 (A rms)
  double rated_power = 0.0;            ///< p0307 (W)
  double power_factor = 0.0;           ///< p0308
  double rated_frequency = 0.0;        ///< p0310 (Hz)
  double rated_speed = 0.0;            ///< p0311
  std::int32_t pole_pairs = 0;         ///< p0314, 0 = those of the machine
  double torque_constant = 0.0;        ///< p0316 (N·m/A rms)
  double magnetising_current = 0.0;    ///< p0320 (A rms)
  double motor_maximum_speed = 0.0;    ///< p0322
  double motor_maximum_current = 0.0;  ///< p0323 (A rms)
  double rated_torque = 0.0;           ///< r0333, of the machine
  double motor_limit_current = 0.0;    ///< p0338 (A rms), 0 = none
  double motor_inertia = 0.0;          ///< p0341
  double inertia_ratio = 1.0;          ///< p0342, of all that turns to the motor's
  double stator_resistance = 0.0;      ///< p0350 (Ω)
  double rotor_resistance = 0.0;       ///< p0354 (Ω)
  double series_inductance = 0.0;      ///< p0353 (H), between power unit and motor
  double stator_leakage = 0.0;         ///< p0356 (H); of a synchronous machine the inductance across its magnets
  double direct_inductance = 0.0;      ///< p0357 (H), of a synchronous machine along its magnets
  double rotor_leakage = 0.0;          ///< p0358 (H)
  double main_inductance = 0.0;        ///< p0360 (H), without saturation
  // Magnetising characteristic of an induction machine, shares of the rated flux and of p0320.
  double characteristic_flux_1 = 0.0;     ///< p0362
  double characteristic_flux_2 = 0.0;     ///< p0363
  double characteristic_flux_3 = 0.0;     ///< p0364
  double characteristic_flux_4 = 0.0;     ///< p0365
  double characteristic_current_1 = 0.0;  ///< p0366
  double characteristic_current_2 = 0.0;  ///< p0367
  double characteristic_current_3 = 0.0;  ///< p0368
  double characteristic_current_4 = 0.0;  ///< p0369

  friend bool operator==(const MotorData&, const MotorData&) = default;
};

/// The machine as @p data describe it to the control: @p machine with p0304 to p0360 in place of its own
/// data.
motor::MachineData believed_machine(const MotorData& data, const motor::MachineData& machine) noexcept;

/// Torque constant (N·m/A rms) of a synchronous machine like @p data_sheet whose magnets have the flux @p
/// magnet_flux (V·s).
constexpr double torque_constant(const motor::MachineData& data_sheet, double magnet_flux) noexcept {
  return data_sheet.torque_constant * magnet_flux / data_sheet.synchronous.magnet_flux;
}

/// The first motor parameter whose value cannot be that of @p machine's kind, such as a resistance of 0; 0 if all
/// can. It is the value of F07950.
std::uint16_t implausible_motor_parameter(const MotorData& data, const motor::MachineData& machine) noexcept;

/// p0300 of @p type.
constexpr std::int32_t motor_type_number(motor::MachineType type) noexcept {
  return type == motor::MachineType::Induction ? 1 : 2;
}

/// Whether p0300 and p0301 of @p data are those of a motor of the list (a number of its series or a code),
/// whose data the unit knows; otherwise only its rating plate is known.
bool is_listed_motor(const MotorData& data) noexcept;

}  // namespace drive
