#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/speed_control/speed_control.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<SpeedControl> = std::array{
    Row{640, 1, kAxes, F32, Unit::AmperesRms, {0.0, 10000.0}, factory::current_limit, When::QuickOrMotorAlways, setting<&SpeedControl::Settings::current_limit>, Output::No, "Current limit", "limits the current"},
    Row{856, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SpeedControl::Inputs::enable>, Output::No, "BI: enable speed controller", "0 leaves no torque"},
    Row{1300, 1, kServo, I16, Unit::None, {20.0, 23.0}, 21.0, When::QuickReady, setting<&SpeedControl::Settings::control_mode>, Output::No, "Open/closed-loop control mode", "0 to 19 V/f, 20 and 22 without encoder, 21 and 23 with it"},
    Row{1300, 1, kVector, I16, Unit::None, {0.0, 23.0}, 20.0, When::QuickReady, setting<&SpeedControl::Settings::control_mode>, Output::No, "Open/closed-loop control mode", "0 to 19 V/f, 20 and 22 without encoder, 21 and 23 with it"},
    Row{1406, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_controller_control>, Output::Both, "Control word speed controller", "bit 12: torque control by p1501"},
    Row{1407, 1, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_controller_status>, Output::Both, "Status word speed controller", "bits 0 V/f, 1 without encoder, 2 torque control, 3 speed control, 7 torque limit reached"},
    Row{1438, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_demand>, Output::Connector, "Speed controller speed setpoint", ""},
    Row{1441, 1, kAxes, F32, Unit::Milliseconds, {0.0, 50.0}, 0.0, When::Always, setting<&SpeedControl::Settings::speed_smoothing>, Output::No, "Actual speed smoothing time", "of what the speed controller sees"},
    Row{1460, 1, kAxes, F32, Unit::NewtonMetreSecondPerRadian, {0.0, 999999.0}, factory::speed_gain, When::Always, setting<&SpeedControl::Settings::speed_gain>, Output::No, "Speed controller P gain", "gain of the speed controller"},
    Row{1462, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, factory::speed_integral_time, When::Always, setting<&SpeedControl::Settings::speed_integral_time>, Output::No, "Speed controller integral time", "0 = no integral part"},
    Row{1470, 1, kAxes, F32, Unit::NewtonMetreSecondPerRadian, {0.0, 999999.0}, factory::encoderless_speed_gain, When::Always, setting<&SpeedControl::Settings::encoderless_speed_gain>, Output::No, "Speed controller P gain encoderless", "as p1460, without encoder"},
    Row{1472, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, factory::encoderless_speed_integral_time, When::Always, setting<&SpeedControl::Settings::encoderless_speed_integral_time>, Output::No, "Speed controller integral time encoderless", "as p1462, without encoder"},
    Row{1496, 1, kAxes, F32, Unit::Percent, {0.0, 10000.0}, 0.0, When::Always, setting<&SpeedControl::Settings::acceleration_precontrol>, Output::No, "Acceleration precontrol scaling", "torque for the ramp from p0341 and p0342; p1960 sets it to 100 % with the inertia that it has found"},
    Row{1501, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SpeedControl::Inputs::torque_control>, Output::No, "BI: changeover speed/torque control", "1 changes from speed to torque control (p1300 = 21)"},
    Row{1530, 1, kAxes, F32, Unit::Kilowatts, {0.0, 100000.0}, factory::motoring_power_limit, When::Always, setting<&SpeedControl::Settings::motoring_power_limit>, Output::No, "Power limit motoring", "limits the torque"},
    Row{1531, 1, kAxes, F32, Unit::Kilowatts, {-100000.0, -0.01}, factory::regenerative_power_limit, When::Always, setting<&SpeedControl::Settings::regenerative_power_limit>, Output::No, "Power limit regenerative", "limits the torque"},
    Row{8762, 1, kAxes, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::mode>, Output::Connector, "CAN operating mode display (CO)", ""},
};
// clang-format on

}  // namespace drive::rows
