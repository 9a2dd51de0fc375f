#pragma once

#include <cstdint>

#include "drive/axis_configuration.hpp"

namespace drive {

/// The parameters of one axis in SI units: rad/s, N·m, s, kg·m².
struct AxisParameters {
  // Motor data: what the control believes of the machine, which itself stays what it is.
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
  double temperature_alarm = 0.0;         ///< p0604 (°C)
  double temperature_fault = 0.0;         ///< p0605 (°C)
  double current_limit = 0.0;             ///< p0640 (A rms)
  // Setpoint channel and OFF functions.
  double jog_speed_1 = 0.0;                 ///< p1058
  double jog_speed_2 = 0.0;                 ///< p1059
  double minimum_speed = 0.0;               ///< p1080
  double maximum_speed = 0.0;               ///< p1082
  double speed_limit_positive = 0.0;        ///< p1083
  double speed_limit_negative = 0.0;        ///< p1086, not positive
  std::int32_t ramp_selection = 0;          ///< p1115: 0 basic, 1 extended with the roundings
  double ramp_up_time = 0.0;                ///< p1120, from zero to p1082
  double ramp_down_time = 0.0;              ///< p1121, from p1082 to zero, also OFF1
  double initial_rounding = 0.0;            ///< p1130
  double final_rounding = 0.0;              ///< p1131
  std::int32_t rounding_type = 0;           ///< p1134: 0 continuous, 1 discontinuous
  double off3_ramp_down_time = 0.0;         ///< p1135, 0 = as fast as the torque limit allows
  double off3_initial_rounding = 0.0;       ///< p1136
  double off3_final_rounding = 0.0;         ///< p1137
  std::int32_t brake_configuration = 0;     ///< p1215: 0 none, 1 and 3 by the sequence control, 2 always open
  double brake_opening_time = 0.0;          ///< p1216, for which the setpoint waits
  double brake_closing_time = 0.0;          ///< p1217, for which the motor still holds
  double standstill_threshold = 0.0;        ///< p1226
  double standstill_monitoring_time = 0.0;  ///< p1227
  double pulse_suppression_delay = 0.0;     ///< p1228
  double power_monitoring_time = 0.0;       ///< p0857
  // Control and its limits.
  std::int32_t control_mode = 0;                 ///< p1300: 0..19 V/f, 20 and 22 without encoder, 21 and 23 with
  double speed_smoothing = 0.0;                  ///< p1441
  double speed_gain = 0.0;                       ///< p1460 (N·m·s/rad)
  double speed_integral_time = 0.0;              ///< p1462, 0 = no integral part
  double encoderless_speed_gain = 0.0;           ///< p1470 (N·m·s/rad)
  double encoderless_speed_integral_time = 0.0;  ///< p1472, 0 = no integral part
  double acceleration_precontrol = 0.0;          ///< p1496, 1 = the whole inertia
  double speed_dynamics = 1.0;                   ///< p1967, of the speed controller that p1960 computes
  double upper_torque_limit = 0.0;               ///< p1520
  double lower_torque_limit = 0.0;               ///< p1521
  double motoring_power_limit = 0.0;             ///< p1530 (W)
  double regenerative_power_limit = 0.0;         ///< p1531 (W), negative
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
AxisParameters commissioned_parameters(const AxisConfiguration& configuration) noexcept;

}  // namespace drive
