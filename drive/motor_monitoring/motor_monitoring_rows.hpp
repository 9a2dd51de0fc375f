#pragma once

#include <array>

#include "drive/motor_monitoring/motor_monitoring.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<MotorMonitoring> = std::array{
    Row{34, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, shown<axis_value::motor_utilisation>, Output::Connector, "Motor thermal utilisation", "of the I2t model"},
    Row{35, 1, kAxes, F32, Unit::Celsius, kWhole, 20.0, When::ReadOnly, shown<axis_value::motor_temperature>, Output::Connector, "Motor temperature", "winding"},
    Row{604, 1, kAxes, F32, Unit::Celsius, {0.0, 200.0}, 120.0, When::Always, setting<&MotorMonitoring::Settings::alarm_temperature>, Output::No, "Motor temperature alarm threshold", "A07910; F07011 if it stays so long"},
    Row{605, 1, kAxes, F32, Unit::Celsius, {0.0, 200.0}, 145.0, When::Always, setting<&MotorMonitoring::Settings::fault_temperature>, Output::No, "Motor temperature fault threshold", "F07011"},
};
// clang-format on

}  // namespace drive::rows
