#pragma once

#include <cstdint>

#include "motor/load.hpp"
#include "motor/machine_data.hpp"

namespace drive {

/// The parameters of one axis in SI units: rad/s, N·m, s, kg·m².
struct AxisParameters {
  // Motor and encoder: they describe the simulated machine; of these only p0322 can be written.
  double rated_speed = 0.0;            ///< p0311
  double motor_maximum_speed = 0.0;    ///< p0322
  double rated_torque = 0.0;           ///< r0333
  double motor_inertia = 0.0;          ///< p0341
  std::int32_t encoder_pulses = 0;     ///< p0408
  std::int32_t encoder_fine_bits = 0;  ///< p0418
  // Setpoint channel and OFF functions.
  double maximum_speed = 0.0;               ///< p1082
  double speed_limit_positive = 0.0;        ///< p1083
  double speed_limit_negative = 0.0;        ///< p1086, not positive
  double ramp_up_time = 0.0;                ///< p1120, from zero to p1082
  double ramp_down_time = 0.0;              ///< p1121, from p1082 to zero, also OFF1
  double off3_ramp_down_time = 0.0;         ///< p1135, 0 = as fast as the torque limit allows
  double standstill_threshold = 0.0;        ///< p1226
  double standstill_monitoring_time = 0.0;  ///< p1227
  double pulse_suppression_delay = 0.0;     ///< p1228
  // Speed controller and torque limits.
  double speed_gain = 0.0;           ///< p1460 (N·m·s/rad)
  double speed_integral_time = 0.0;  ///< p1462, 0 = no integral part
  double upper_torque_limit = 0.0;   ///< p1520
  double lower_torque_limit = 0.0;   ///< p1521
  // References.
  double reference_speed = 0.0;   ///< p2000
  double reference_torque = 0.0;  ///< p2003
  // Messages and monitoring.
  double zero_speed_threshold = 0.0;     ///< p2161, statusword bit 12
  double overspeed_hysteresis = 0.0;     ///< p2162, F07901
  double target_window = 0.0;            ///< p2163, statusword bit 10
  double target_hysteresis = 0.0;        ///< p2164
  double target_off_delay = 0.0;         ///< p2166
  double blocked_speed_threshold = 0.0;  ///< p2175, F07900
  double blocked_delay = 0.0;            ///< p2177, F07900
  // Commissioning and behaviour on the bus.
  std::int32_t commissioning = 0;            ///< p0010, not 0 = switching on is inhibited
  std::int32_t abort_connection_option = 0;  ///< p8641 (6007h): 0 none, 1 OFF1, 2 OFF2, 3 OFF3
  std::int32_t halt_option = 0;  ///< p8791 (605Dh): -1 no function, 0 pulses off, 1 p1121, 2 p1135, 3 torque limit

  friend bool operator==(const AxisParameters&, const AxisParameters&) = default;
};

/// Parameters of a newly commissioned axis: factory values, with everything that depends on the motor computed.
AxisParameters commissioned_parameters(const motor::MachineData& machine, const motor::Load& load) noexcept;

}  // namespace drive
