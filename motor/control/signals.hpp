#pragma once

#include <cstdint>

#include "motor/control/speed_controller.hpp"
#include "motor/data/control_period.hpp"

namespace motor {

/// What a drive train is told for one step.
template <class Number>
struct DriveCommandOf {
  bool pulses_enabled = false;              ///< off: no voltage, the controllers are emptied, the shaft coasts
  Number speed_setpoint = 0.0;              ///< (rad/s)
  Number acceleration_setpoint = 0.0;       ///< slope of the speed setpoint, for the precontrol (rad/s²)
  Condition<Number> torque_control{false};  ///< p1300 = 22, 23: torque_setpoint alone leads
  Number torque_setpoint = 0.0;             ///< of torque control (N·m)
  Number additional_torque = 0.0;           ///< added to it, or to what the speed controller wants (N·m)
  TorqueLimitsOf<Number> limits{};          ///< p1520, p1521
};
using DriveCommand = DriveCommandOf<double>;

/// What can be seen of a drive train after a step. Currents and voltages are amplitudes of a phase.
template <class Number>
struct SignalsOf {
  Number measured_speed = 0.0;      ///< from encoder or estimate, what the controller sees (rad/s)
  Number true_speed = 0.0;          ///< of the shaft (rad/s)
  Number torque_setpoint = 0.0;     ///< r0079 (N·m)
  Number torque = 0.0;              ///< r0080, computed from currents with the data of the machine (N·m)
  Number true_torque = 0.0;         ///< in the air gap, mean of the step (N·m)
  std::int64_t encoder_counts = 0;  ///< increments since power-on
  Condition<Number> torque_limit_reached{false};  ///< r1407.7
  TorqueLimitsOf<Number>
      torque_limits{};              ///< effective after current, power and voltage limits, r1538, r1539 (N·m)
  Number d_current = 0.0;           ///< along the flux (A peak)
  Number q_current = 0.0;           ///< across the flux, makes the torque (A peak)
  Number d_current_setpoint = 0.0;  ///< r0075 (A peak)
  Number q_current_setpoint = 0.0;  ///< r0077 (A peak)
  Number current = 0.0;             ///< r0027·sqrt(2) (A peak)
  Number voltage = 0.0;             ///< at the terminals, r0025 (V peak of a phase)
  Number frequency = 0.0;           ///< of the voltage, r0024 (electrical rad/s)
  Number power = 0.0;               ///< at the terminals, mean of the step, r0032 (W)
  Condition<Number> voltage_limited{false};  ///< the DC link does not give what the current controllers want
  /// The flux is there; before, an induction machine gives no torque, r0056.4.
  Condition<Number> magnetised{false};
  Number flux = 0.0;                    ///< of the rotor, as the control believes, r0084 (V·s)
  Number winding_temperature = 20.0;    ///< true one, what a sensor sees, r0035 (°C)
  Number frame_temperature = 20.0;      ///< (°C)
  Number overload = 0.0;                ///< I²t of the power unit, r0036 (1 = 100 %)
  Number heat_sink_temperature = 20.0;  ///< r0037 (°C)
  Number chip_temperature = 20.0;       ///< r0037 (°C)
  Number motor_utilisation = 0.0;       ///< of the drive's own I²t model, r0034 (1 = 100 %)
};
using Signals = SignalsOf<double>;

}  // namespace motor
