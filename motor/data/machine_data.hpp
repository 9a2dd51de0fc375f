#pragma once

#include <cstdint>
#include <numbers>

namespace motor {

/// One revolution per minute (rad/s).
inline constexpr double kRpm = 2.0 * std::numbers::pi / 60.0;

/// Temperature that resistances and fluxes of machine data refer to (°C).
inline constexpr double kDataTemperature = 20.0;

/// How a machine makes its torque, p0300.
enum class MachineType : std::uint8_t { Synchronous, Induction };

/// The magnetic circuit of a permanent-magnet synchronous machine; rotor coordinates, d = axis of the magnets.
struct SynchronousData {
  double d_inductance = 5.5e-3;  ///< p0357 (H), positive
  double q_inductance = 5.5e-3;  ///< p0356 (H), positive
  double magnet_flux = 0.17348;  ///< at kDataTemperature (V·s, peak), positive
  /// Share of the torque constant that is lost at maximum_current, by saturation above stall_current; 0..0.5.
  double torque_saturation = 0.0909;
  double magnet_temperature_coefficient = -0.0010;  ///< of the flux (1/K), -0.005..0

  friend bool operator==(const SynchronousData&, const SynchronousData&) = default;
};

/// The T circuit of an induction machine, rotor values seen from the stator.
struct InductionData {
  double rotor_resistance = 1.78;            ///< p0354 at kDataTemperature (Ω), positive
  double stator_leakage = 12.31e-3;          ///< p0356 (H), positive
  double rotor_leakage = 12.31e-3;           ///< p0358 (H), positive
  double magnetising_inductance = 294.4e-3;  ///< p0360 (H), positive
  double magnetising_current = 2.4;          ///< p0320 (A rms), positive
  /// Rotor flux (V·s, peak) at which saturation has halved the magnetising inductance; 0 = no saturation.
  double saturation_flux = 0.0;
};

/// Two bodies, winding and frame, between copper losses and the air.
struct ThermalData {
  double winding_capacity = 883.0;  ///< (J/K), positive
  double frame_capacity = 2648.0;   ///< (J/K), positive
  double winding_to_frame = 4.203;  ///< (W/K), positive
  double frame_to_ambient = 2.263;  ///< (W/K), positive
  double ambient = 20.0;            ///< (°C)
};

/// What counts as the shaft turns.
enum class EncoderType : std::uint8_t { None, Incremental, Absolute };

/// Motor encoder.
struct EncoderData {
  EncoderType type = EncoderType::Incremental;
  std::uint32_t pulses = 2048;          ///< p0408 (pulses per revolution), 1..16777215
  std::uint8_t fine_bits = 11;          ///< p0418 (bits per pulse), 2..18
  std::uint32_t revolutions = 4096;     ///< p0421, what an absolute encoder can tell apart, 1..65535
  std::uint8_t absolute_fine_bits = 9;  ///< p0419, of the absolute position (bits per pulse), 2..18
  double start_position = 0.0;          ///< at power-on, past the zero of the disc (revolutions)
};

/// Data of a machine as on its rating plate and in its data sheet. The defaults describe a 3000 rpm servo of the
/// 1FK7063 class; currents and voltages of the rating plate are rms, voltages between lines.
struct MachineData {
  MachineType type = MachineType::Synchronous;
  std::uint8_t pole_pairs = 4;           ///< p0314, 1..255
  double rated_voltage = 330.0;          ///< p0304 (V rms)
  double rated_current = 5.6;            ///< p0305 (A rms)
  double rated_power = 2293.0;           ///< p0307 (W)
  double power_factor = 0.0;             ///< p0308, 0 = not on the plate (synchronous)
  double rated_frequency = 200.0;        ///< p0310 (Hz)
  double rated_speed = 3000.0 * kRpm;    ///< p0311 (rad/s)
  double maximum_speed = 7200.0 * kRpm;  ///< p0322 (rad/s)
  double rated_torque = 7.3;             ///< r0333 (N·m)
  double maximum_torque = 35.0;          ///< at maximum_current (N·m)
  double torque_constant = 1.37;         ///< p0316 (N·m/A rms), 0 for an induction machine
  double stall_current = 8.0;            ///< p0318 (A rms)
  double maximum_current = 28.0;         ///< p0323 (A rms)
  double stator_resistance = 0.55;       ///< p0350 of one phase at kDataTemperature (Ω), positive
  SynchronousData synchronous{};         ///< counts for MachineType::Synchronous
  InductionData induction{};             ///< counts for MachineType::Induction
  double inertia = 0.00151;              ///< rotor, p0341 (kg·m²), positive
  double coulomb_friction = 0.1;         ///< bearings and seals, independent of speed (N·m)
  double viscous_friction = 2e-4;        ///< (N·m·s/rad)
  double hysteresis_torque = 0.0;        ///< iron losses that grow with the speed, as a drag (N·m)
  double eddy_current_drag = 0.0;        ///< iron losses that grow with its square, as a drag (N·m·s/rad)
  ThermalData thermal{};
  EncoderData encoder{};
};

/// Speed at which the rotor of @p machine breaks (rad/s): 1.5 times the maximum speed. Rotors are tested at 1.2
/// times (IEC 60034-1); the stress grows with the square.
constexpr double bursting_speed(const MachineData& machine) noexcept {
  constexpr double kMargin = 1.5;
  return kMargin * machine.maximum_speed;
}

/// Encoder increments in one revolution: pulses times 2 to the fine resolution.
constexpr double increments_per_revolution(const EncoderData& encoder) noexcept {
  return static_cast<double>(static_cast<std::uint64_t>(encoder.pulses) << encoder.fine_bits);
}
/// Encoder increments in one revolution of @p machine.
constexpr double increments_per_revolution(const MachineData& machine) noexcept {
  return increments_per_revolution(machine.encoder);
}

}  // namespace motor
