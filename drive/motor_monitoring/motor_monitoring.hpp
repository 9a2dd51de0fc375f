#pragma once

#include <array>

#include "drive/messages/cause.hpp"
#include "motor/control/signals.hpp"

namespace drive {

/// The temperature of the motor, measured in the winding and as its I²t model has it.
class MotorMonitoring {
 public:
  struct Settings {
    using Block = MotorMonitoring;

    double alarm_temperature = 0.0;  ///< p0604 (°C)
    double fault_temperature = 0.0;  ///< p0605 (°C)
  };

  /// At the end of a cycle that ended with @p signals.
  void observe(const motor::Signals& signals) noexcept {
    temperature_ = signals.winding_temperature;
    utilisation_ = signals.motor_utilisation;
  }
  double temperature() const noexcept { return temperature_; }  ///< r0035 (°C)
  double utilisation() const noexcept { return utilisation_; }  ///< r0034, 1 = 100 %

  Settings settings{};

 private:
  double temperature_ = 0.0;
  double utilisation_ = 0.0;
};

// clang-format off
template <>
inline constexpr auto causes_of<MotorMonitoring> = std::array{
    CauseRow<MotorMonitoring>{7011, &MotorMonitoring::temperature, Side::Above, &MotorMonitoring::Settings::fault_temperature, 2.0, cause::kAtOnce, Pulses::Any, &MotorMonitoring::temperature, 10.0, "p0605"},
    CauseRow<MotorMonitoring>{7011, &MotorMonitoring::temperature, Side::Above, &MotorMonitoring::Settings::alarm_temperature, 2.0, 240.0, Pulses::Any, &MotorMonitoring::temperature, 10.0, "p0604 for longer than p0606, whose factory value is 240 s"},
    CauseRow<MotorMonitoring>{7012, &MotorMonitoring::utilisation, Side::Above, 1.1, 0.02, cause::kAtOnce, Pulses::Any, nullptr, cause::kNone, "I2t model at 110 %, the factory value of p5390"},
    CauseRow<MotorMonitoring>{7910, &MotorMonitoring::temperature, Side::Above, &MotorMonitoring::Settings::alarm_temperature, 2.0, cause::kAtOnce, Pulses::Any, &MotorMonitoring::temperature, 10.0, "p0604"},
};
// clang-format on

}  // namespace drive
