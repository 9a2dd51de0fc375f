#pragma once

#include <cstdint>

namespace motor {

/// How the DC link is fed.
enum class Infeed : std::uint8_t {
  Diode,         ///< rectifier: feeds only, the voltage sags and rises
  Regenerative,  ///< follows the line in both directions
  Active,        ///< holds the voltage in both directions
};

/// DC link with infeed and braking chopper, common to all axes of a unit.
struct SupplyData {
  Infeed infeed = Infeed::Diode;
  double line_voltage = 400.0;       ///< p0210 (V rms between lines), positive; 0 switches the supply off
  double active_voltage = 600.0;     ///< setpoint of Infeed::Active (V)
  double line_resistance = 0.3;      ///< of supply and rectifier, seen from the DC link (Ω), positive
  double rated_power = 36e3;         ///< what a Regenerative or Active infeed carries either way (W)
  double capacitance = 1.175e-3;     ///< of the unit, precharged (F), positive
  double chopper_resistance = 20.0;  ///< (Ω); 0 = no chopper
  double chopper_on = 774.0;         ///< (V)
  double chopper_off = 759.0;        ///< (V), below chopper_on
  double chopper_sampling = 0.0;     ///< how often its comparator looks (s); 0 = always
  double overvoltage = 820.0;        ///< trip (V)
  double undervoltage = 360.0;       ///< trip (V)
};

}  // namespace motor
