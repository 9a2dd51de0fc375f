#pragma once

namespace motor {

/// A power unit: what it can carry, what it loses and how it warms. The defaults are an 18 A module, which gives
/// the default machine its maximum torque; heat and overload constants are plausible, not the vendor's.
struct InverterData {
  double rated_current = 18.0;    ///< r0207 (A rms), positive
  double maximum_current = 36.0;  ///< r0209 (A rms), above rated_current
  double trip_current = 75.0;     ///< hardware overcurrent of a phase (A peak), above sqrt(2) maximum_current
  double dead_time = 0.0;         ///< between the switches of a phase (s); 0 = ideal
  double forward_voltage = 0.0;   ///< drop of a switch or diode (V)
  double pulse_frequency = 8e3;   ///< p1800 (Hz), positive
  /// Losses c0 + c1 I + c2 I² of the whole unit, I in A rms.
  double idle_losses = 30.0;               ///< c0, pulses on (W)
  double losses_per_ampere = 6.0;          ///< c1 (W/A)
  double losses_per_square = 0.08;         ///< c2 (W/A²)
  double overload_time_constant = 12.0;    ///< of I²t (s), positive
  double chip_time_constant = 0.15;        ///< (s), positive
  double chip_rise = 25.0;                 ///< of the chip above the heat sink at rated current (K)
  double heat_sink_time_constant = 240.0;  ///< (s), positive
  double heat_sink_rise = 35.0;            ///< above the air at rated current (K)
  double ambient = 30.0;                   ///< (°C)
};

}  // namespace motor
