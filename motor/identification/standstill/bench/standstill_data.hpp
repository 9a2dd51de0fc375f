#pragma once

#include <cstdint>

#include "motor/control/control_settings.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/identification/model/saturation_curve.hpp"

namespace motor {

/// Why a measurement at standstill failed: the values of F07990.
enum class StandstillFault : std::uint8_t {
  None = 0,
  CurrentLimit = 1,      ///< the current limit is too low, or was passed
  StatorResistance = 2,  ///< found beyond what the rating plate allows; so are the next ones
  RotorResistance = 3,
  StatorReactance = 4,  ///< of one axis of a synchronous machine
  MainReactance = 5,
  RotorTimeConstant = 6,
  Leakage = 7,
  ShaftTurns = 11,    ///< further than StandstillTask::largest_travel, or all the time
  PolePosition = 12,  ///< the shaft does not follow, or the other way
  ThresholdVoltage = 20,
  VoltageLimited = 30,  ///< the DC link does not give the current
};

/// What a measurement at standstill starts from: nothing but what the drive believes.
struct StandstillTask {
  MachineData machine{};
  ControlSettings settings{};
  double winding_temperature = kDataTemperature;  ///< from its sensor (°C)
  double largest_travel = 1.5708;                 ///< of the shaft (rad)
  bool finds_curve = false;  ///< of an induction machine: its saturation characteristic besides the rest
};

/// What it finds. Resistances are those at kDataTemperature.
struct StandstillResult {
  double stator_resistance = 0.0;       ///< r1912 (Ω)
  double threshold_voltage = 0.0;       ///< r1925, what each phase loses to dead time and valves (V)
  double d_inductance = 0.0;            ///< r1932, of a synchronous machine as the next two (H)
  double q_inductance = 0.0;            ///< r1934 (H)
  double pole_position = 0.0;           ///< r1984, of the rotor past where the encoder has it (electrical rad)
  double rotor_resistance = 0.0;        ///< r1927, of the inverse-Gamma circuit, as the next two (Ω)
  double leakage = 0.0;                 ///< r1914 (H)
  double magnetising_inductance = 0.0;  ///< r1936, without saturation (H)
  double travel = 0.0;                  ///< the furthest way that the shaft made (rad)
  SaturationCurve curve{};              ///< where it was asked for
};

}  // namespace motor
