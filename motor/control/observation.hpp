#pragma once

#include <cstdint>

#include "motor/control/speed_controller.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// What a drive knows of its axis after a step, all of it through sensors or its own computation; nothing is the
/// truth of the simulation.
struct Observation {
  SpaceVector current{};            ///< stator frame, from the current sensors (A)
  SpaceVector voltage{};            ///< that the inverter was asked for in this step, stator frame (V)
  double dc_voltage = 0.0;          ///< (V)
  std::int64_t encoder_counts = 0;  ///< increments since power-on; stay 0 without encoder
  double speed = 0.0;               ///< from encoder or observer, as the control sees it (rad/s)
  double frequency = 0.0;           ///< of the flux (electrical rad/s)
  double d_current = 0.0;           ///< along the flux (A peak)
  double q_current = 0.0;           ///< across the flux (A peak)
  double torque_setpoint = 0.0;     ///< (N·m)
  double torque = 0.0;              ///< from currents and what is believed of the machine (N·m)
  TorqueLimits torque_limits{};     ///< effective (N·m)
  bool torque_limit_reached = false;
  bool voltage_limited = false;
  bool magnetised = false;
  double winding_temperature = 20.0;  ///< from its sensor (°C)
};

}  // namespace motor
