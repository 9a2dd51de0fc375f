#pragma once

#include <cstdint>

#include "motor/control/speed_controller.hpp"

namespace motor {

/// How a machine is led, p1300.
enum class ControlMode : std::uint8_t {
  VoltageFrequency,  ///< 0..19: voltage by frequency, without encoder
  Sensorless,        ///< 20, 22: field-oriented with the speed estimated from voltages and currents
  Encoder,           ///< 21, 23: field-oriented with the motor encoder
};

/// Settings of the current controllers, one for each axis of the rotor frame.
struct CurrentControllerGains {
  double d_proportional = 0.0;   ///< p1715 (V/A)
  double q_proportional = 0.0;   ///< p1715 (V/A)
  double d_integral_time = 0.0;  ///< p1717 (s), positive
  double q_integral_time = 0.0;  ///< p1717 (s), positive

  friend bool operator==(const CurrentControllerGains&, const CurrentControllerGains&) = default;
};

/// Settings of V/f control. Voltages are rms between lines.
struct VoltageFrequencySettings {
  double rated_voltage = 400.0;      ///< at rated_frequency, p0304 (V)
  double rated_frequency = 50.0;     ///< p0310 (Hz), positive
  double boost = 0.0;                ///< at standstill, fades to 0 at the rated frequency, p1310 (V)
  double acceleration_boost = 0.0;   ///< added while the frequency rises or falls, p1311 (V)
  bool parabolic = false;            ///< p1300 = 2: for fans
  double slip_compensation = 0.0;    ///< share of the rated slip that is compensated at rated torque, p1335
  double resonance_damping = 0.0;    ///< gain of the active current on the frequency, p1338
  double frequency_reduction = 2.0;  ///< of the I_max controller: rated frequencies a second at twice the limit

  friend bool operator==(const VoltageFrequencySettings&, const VoltageFrequencySettings&) = default;
};

/// Settings of all control loops of an axis. computed_settings() fills them from the rating plate, as p0340 does.
struct ControlSettings {
  ControlMode mode = ControlMode::Encoder;
  SpeedControllerGains speed{};             ///< with encoder, p1460, p1462
  SpeedControllerGains sensorless_speed{};  ///< without encoder, p1470, p1472
  CurrentControllerGains current{};
  double current_limit = 0.0;             ///< p0640 (A rms), positive
  double motoring_power_limit = 0.0;      ///< at the shaft, p1530 (W), not negative
  double regenerative_power_limit = 0.0;  ///< at the shaft, p1531 (W), not positive
  double inertia = 0.0;                   ///< machine and load, p0341·p0342 (kg·m²), positive
  double acceleration_precontrol = 0.0;   ///< of the torque for inertia times acceleration, p1496; 1 = 100 %
  double speed_smoothing = 0.0;           ///< of the measured speed, p1441 (s)
  double changeover_speed = 0.0;          ///< below it sensorless control feeds a turning current, p1755 (rad/s)
  double start_current = 0.0;             ///< that current (A rms), p1610
  double vdc_max = 0.0;  ///< DC link voltage at which generating torque is gone (V), r1242; 0 = never
  VoltageFrequencySettings voltage_frequency{};

  friend bool operator==(const ControlSettings&, const ControlSettings&) = default;
};

}  // namespace motor
