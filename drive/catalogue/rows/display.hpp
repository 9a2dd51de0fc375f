#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/unit_values.hpp"

namespace drive::rows {

/// What an axis shows: speeds, torques, currents, temperatures.
// clang-format off
inline constexpr std::array kDisplayRows{
    Row{2, 1, kControlUnit, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<unit_value::operating_display>, Output::Connector, "Control Unit operating display", "34 while p0009 is not 0"},
    Row{20, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_demand>, Output::Connector, "Speed setpoint smoothed", ""},
    Row{24, 1, kAxes, F32, Unit::Hertz, kWhole, 0.0, When::ReadOnly, shown<axis_value::output_frequency>, Output::Connector, "Output frequency smoothed", ""},
    Row{29, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::field_current>, Output::Connector, "Field-generating current smoothed", ""},
    Row{30, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque_current>, Output::Connector, "Torque-generating current smoothed", ""},
    Row{32, 1, kAxes, F32, Unit::Kilowatts, kWhole, 0.0, When::ReadOnly, shown<axis_value::active_power>, Output::Connector, "Active power smoothed", "at the motor terminals"},
    Row{33, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque_utilisation>, Output::Connector, "Torque utilisation smoothed", "of the effective limit"},
    Row{37, 2, kControlUnit, F32, Unit::Celsius, kWhole, 40.0, When::ReadOnly, Fixed{40.0, "a thermal model of the control unit"}, Output::Connector, "CU temperature [0] actual [1] max", ""},
    Row{54, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::controlword>, Output::Both, "Control word 1 (VECTOR)", "the one in force"},
    Row{56, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::control_status>, Output::Both, "Status word closed-loop control", "bits 0, 2 and 13"},
    Row{60, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_demand>, Output::Connector, "Speed setpoint before filter", ""},
    Row{62, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_demand>, Output::Connector, "Speed setpoint after filter", ""},
    Row{64, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_deviation>, Output::Connector, "Speed controller deviation", ""},
    Row{66, 1, kAxes, F32, Unit::Hertz, kWhole, 0.0, When::ReadOnly, shown<axis_value::output_frequency>, Output::Connector, "Output frequency", ""},
    Row{76, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::field_current>, Output::Connector, "Field-generating current actual", ""},
    Row{77, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque_current_setpoint>, Output::Connector, "Torque-generating current setpoint", ""},
    Row{78, 2, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque_current>, Output::Connector, "Torque-generating current actual", "both indices"},
    Row{81, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque_utilisation>, Output::Connector, "Torque utilisation", "of the effective limit"},
    Row{82, 3, kAxes, F32, Unit::Kilowatts, kWhole, 0.0, When::ReadOnly, shown<axis_value::active_power>, Output::Connector, "Active power actual value", "as r0032, every index"},
};
// clang-format on

}  // namespace drive::rows
