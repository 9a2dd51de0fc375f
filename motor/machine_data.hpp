#pragma once

#include <cstdint>
#include <numbers>

namespace motor {

/// One revolution per minute (rad/s).
inline constexpr double kRpm = 2.0 * std::numbers::pi / 60.0;

/// Data of a machine with its encoder and inverter; the defaults describe a 3000 rpm servo of the 1FK7063 class.
struct MachineData {
  double rated_speed = 3000.0 * kRpm;          ///< p0311 (rad/s)
  double maximum_speed = 7200.0 * kRpm;        ///< p0322 (rad/s)
  double rated_torque = 7.3;                   ///< r0333 (N·m)
  double maximum_torque = 35.0;                ///< highest torque at the current limit (N·m)
  double inertia = 0.00151;                    ///< rotor, p0341 (kg·m²)
  double current_loop_time_constant = 400e-6;  ///< torque response to its setpoint (s)
  double coulomb_friction = 0.1;               ///< bearings and seals, independent of speed (N·m)
  double viscous_friction = 2e-4;              ///< (N·m·s/rad)
  std::uint32_t encoder_pulses = 2048;         ///< p0408 (pulses per revolution)
  std::uint8_t encoder_fine_bits = 11;         ///< p0418 (bits per pulse), 2..18
};

/// Encoder increments in one revolution: pulses times 2 to the fine resolution.
constexpr double increments_per_revolution(const MachineData& machine) noexcept {
  return static_cast<double>(static_cast<std::uint64_t>(machine.encoder_pulses) << machine.encoder_fine_bits);
}

}  // namespace motor
