#pragma once

#include <array>

#include "drive/parameter/axis_values.hpp"
#include "drive/parameter/row.hpp"
#include "drive/parameter/unit_values.hpp"

namespace drive::rows {

/// What an axis shows: speeds, torques, currents, temperatures.
// clang-format off
inline constexpr std::array kDisplayRows{
    Row{2, 1, kControlUnit, I16, Unit::None, kWhole, 0.0, When::ReadOnly, unit(unit_value::operating_display), Output::Connector, "Control Unit operating display", "34 while p0009 is not 0"},
    Row{2, 1, kAxes, I16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::operating_display), Output::Connector, "Drive operating display", "from state and controlword"},
    Row{20, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_demand), Output::Connector, "Speed setpoint smoothed", ""},
    Row{21, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed), Output::Connector, "Speed actual value smoothed", ""},
    Row{24, 1, kAxes, F32, Unit::Hertz, kWhole, 0.0, When::ReadOnly, axis(axis_value::output_frequency), Output::Connector, "Output frequency smoothed", ""},
    Row{25, 1, kAxes, F32, Unit::VoltsRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::output_voltage), Output::Connector, "Output voltage smoothed", ""},
    Row{26, 1, kAxes, F32, Unit::Volts, kWhole, 600.0, When::ReadOnly, axis(axis_value::dc_voltage), Output::Connector, "DC link voltage smoothed", ""},
    Row{27, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::current), Output::Connector, "Absolute current smoothed", ""},
    Row{28, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, axis(axis_value::modulation_depth), Output::Connector, "Modulation depth smoothed", "of the highest voltage without overmodulation"},
    Row{29, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::field_current), Output::Connector, "Field-generating current smoothed", ""},
    Row{30, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque_current), Output::Connector, "Torque-generating current smoothed", ""},
    Row{31, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque), Output::Connector, "Torque actual value smoothed", ""},
    Row{32, 1, kAxes, F32, Unit::Kilowatts, kWhole, 0.0, When::ReadOnly, axis(axis_value::active_power), Output::Connector, "Active power smoothed", "at the motor terminals"},
    Row{33, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque_utilisation), Output::Connector, "Torque utilisation smoothed", "of the effective limit"},
    Row{34, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, axis(axis_value::motor_utilisation), Output::Connector, "Motor thermal utilisation", "of the I2t model"},
    Row{35, 1, kAxes, F32, Unit::Celsius, kWhole, 20.0, When::ReadOnly, axis(axis_value::motor_temperature), Output::Connector, "Motor temperature", "winding"},
    Row{36, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, axis(axis_value::overload), Output::Connector, "Power unit overload I2t", ""},
    Row{37, 2, kControlUnit, F32, Unit::Celsius, kWhole, 40.0, When::ReadOnly, Fixed{40.0, "a thermal model of the control unit"}, Output::Connector, "CU temperature [0] actual [1] max", ""},
    Row{37, 20, kAxes, F32, Unit::Celsius, kWhole, 30.0, When::ReadOnly, axis(axis_value::power_unit_temperature), Output::Connector, "Power unit temperatures", "[0] heat sink, [1] chip; others the air"},
    Row{39, 3, kAxes, F32, Unit::KilowattHours, kWhole, 0.0, When::ReadOnly, axis(axis_value::energy), Output::Connector, "Energy display: balance, drawn, fed back", "[0] balance, [1] drawn, [2] fed back at the motor terminals; a power cut keeps them"},
    Row{42, 3, kAxes, I32, Unit::WattHours, kWhole, 0.0, When::ReadOnly, axis(axis_value::process_energy), Output::Connector, "Process energy display", "as r0039"},
    Row{46, 1, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::missing_enables), Output::Both, "Missing enable signals", ""},
    Row{53, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_status), Output::Both, "Status word 2 (VECTOR)", "bits 1, 4, 5 and 6"},
    Row{54, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::controlword), Output::Both, "Control word 1 (VECTOR)", "the one in force"},
    Row{56, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::control_status), Output::Both, "Status word closed-loop control", "bits 0 and 2"},
    Row{60, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_demand), Output::Connector, "Speed setpoint before filter", ""},
    Row{61, 2, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::encoder_speed), Output::Connector, "Speed actual value unsmoothed (encoder)", "[0] of the motor encoder; other encoders 0"},
    Row{62, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_demand), Output::Connector, "Speed setpoint after filter", ""},
    Row{63, 3, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed), Output::Connector, "Speed actual value", "mean of a cycle, every index"},
    Row{64, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_deviation), Output::Connector, "Speed controller deviation", ""},
    Row{66, 1, kAxes, F32, Unit::Hertz, kWhole, 0.0, When::ReadOnly, axis(axis_value::output_frequency), Output::Connector, "Output frequency", ""},
    Row{67, 2, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::maximum_current), Output::Connector, "Maximum drive output current", "[0] of all limits, [1] of the power unit"},
    Row{68, 2, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::current), Output::Connector, "Absolute current actual value", "both indices"},
    Row{69, 7, kAxes, F32, Unit::Amperes, kWhole, 0.0, When::ReadOnly, axis(axis_value::phase_current), Output::Connector, "Phase current actual values", "[0..2] phases U, V, W; others 0"},
    Row{70, 1, kAxes, F32, Unit::Volts, kWhole, 600.0, When::ReadOnly, axis(axis_value::dc_voltage), Output::Connector, "DC link voltage actual value", ""},
    Row{72, 1, kAxes, F32, Unit::VoltsRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::output_voltage), Output::Connector, "Output voltage", ""},
    Row{76, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::field_current), Output::Connector, "Field-generating current actual", ""},
    Row{77, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque_current_setpoint), Output::Connector, "Torque-generating current setpoint", ""},
    Row{78, 2, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque_current), Output::Connector, "Torque-generating current actual", "both indices"},
    Row{79, 2, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque_demand), Output::Connector, "Total torque setpoint", "both indices"},
    Row{80, 2, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque), Output::Connector, "Torque actual value [0] unsmoothed [1] smoothed", "mean of a cycle, both indices"},
    Row{81, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque_utilisation), Output::Connector, "Torque utilisation", "of the effective limit"},
    Row{82, 3, kAxes, F32, Unit::Kilowatts, kWhole, 0.0, When::ReadOnly, axis(axis_value::active_power), Output::Connector, "Active power actual value", "as r0032, every index"},
};
// clang-format on

}  // namespace drive::rows
