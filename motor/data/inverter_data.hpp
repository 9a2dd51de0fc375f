#pragma once

#include <array>

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

/// Trip current (A peak) over maximum current (A rms).
inline constexpr double kTripRatio = 75.0 / 36.0;

/// A power unit of @p rated_current (A rms, positive) with the properties of the default one in proportion.
constexpr InverterData inverter_of(double rated_current) noexcept {
  const InverterData model{};
  InverterData unit = model;
  const double size = rated_current / model.rated_current;
  unit.rated_current = rated_current;
  unit.maximum_current = 2.0 * rated_current;
  unit.trip_current = kTripRatio * unit.maximum_current;
  unit.idle_losses = model.idle_losses * size;
  unit.losses_per_square = model.losses_per_square / size;
  return unit;
}

/// Rated currents of the power units of the series (A rms).
inline constexpr std::array kRatedCurrents{3.0, 5.0, 9.0, 18.0, 30.0, 45.0, 60.0, 85.0, 132.0, 200.0};

/// The smallest power unit of the series that gives @p maximum_current (A rms); beyond it, one made for it.
constexpr InverterData inverter_for(double maximum_current) noexcept {
  for (const double rated : kRatedCurrents)
    if (inverter_of(rated).maximum_current >= maximum_current) return inverter_of(rated);
  return inverter_of(0.5 * maximum_current);
}

}  // namespace motor
