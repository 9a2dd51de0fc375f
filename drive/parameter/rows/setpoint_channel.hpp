#pragma once

#include <array>

#include "drive/parameter/axis_values.hpp"
#include "drive/parameter/factory_values.hpp"
#include "drive/parameter/row.hpp"

namespace drive::rows {

/// Sequence control and setpoint channel.
// clang-format off
inline constexpr std::array kSetpointChannelRows{
    Row{840, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 0), When::Always, Stored{}, Output::No, "BI: ON/OFF1", ""},
    Row{844, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 1), When::Always, Stored{}, Output::No, "BI: OFF2 source 1", ""},
    Row{845, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: OFF2 source 2", ""},
    Row{848, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 2), When::Always, Stored{}, Output::No, "BI: OFF3 source 1", ""},
    Row{849, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: OFF3 source 2", ""},
    Row{852, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 3), When::Always, Stored{}, Output::No, "BI: enable operation", ""},
    Row{854, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: control by PLC", ""},
    Row{856, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: enable speed controller", ""},
    Row{857, 1, kAxes, F32, Unit::Milliseconds, {100.0, 60000.0}, 6000.0, When::Always, Member{&P::power_monitoring_time}, Output::No, "Power unit monitoring time", "F07840 or F07802 when infeed or DC link do not come within it after ON"},
    Row{864, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: infeed operation", ""},
    Row{898, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::sequence_control), Output::Both, "Control word sequence control", ""},
    Row{899, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::sequence_status), Output::Both, "Status word sequence control (ZSW1 source)", ""},
    Row{1000, 1, kAxes, U32, Unit::None, {0.0, 999999.0}, 0.0, When::Always, Stored{}, Output::No, "Macro connector inputs speed setpoint", ""},
    Row{1070, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(8860, 1), When::Always, Stored{}, Output::No, "CI: main setpoint", ""},
    Row{1075, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{}, Output::No, "CI: supplementary setpoint", ""},
    Row{1080, 1, kAxes, F32, Unit::Rpm, {0.0, 19500.0}, 0.0, When::Always, Stored{}, Output::No, "Minimum speed", ""},
    Row{1082, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, factory::motor_maximum_speed, When::QuickReady, Member{&P::maximum_speed}, Output::No, "Maximum speed", "highest speed setpoint; p1120, p1121 and p1135 count from it"},
    Row{1083, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 210000.0, When::Always, Member{&P::speed_limit_positive}, Output::Connector, "Speed limit positive", "limits the setpoint and F07901"},
    Row{1085, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(1083, 0), When::Always, Stored{}, Output::No, "CI: speed limit positive direction", ""},
    Row{1086, 1, kAxes, F32, Unit::Rpm, {-210000.0, 0.0}, -210000.0, When::Always, Member{&P::speed_limit_negative}, Output::Connector, "Speed limit negative", "limits the setpoint and F07901"},
    Row{1113, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{}, Output::No, "BI: setpoint inversion", ""},
    Row{1115, 1, kServo, I16, Unit::None, {0.0, 1.0}, 0.0, When::Ready, Member{&P::ramp_selection}, Output::No, "Ramp-function generator selection", "1 rounds the ends of the ramp"},
    Row{1115, 1, kVector, I16, Unit::None, {0.0, 1.0}, 1.0, When::Ready, Member{&P::ramp_selection}, Output::No, "Ramp-function generator selection", "1 rounds the ends of the ramp"},
    Row{1119, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::ramp_input), Output::Connector, "RFG setpoint at input", ""},
    Row{1120, 1, kAxes, F32, Unit::Seconds, {0.0, 999999.0}, 10.0, When::Always, Member{&P::ramp_up_time}, Output::No, "RFG ramp-up time", "ramp from zero to p1082"},
    Row{1121, 1, kAxes, F32, Unit::Seconds, {0.0, 999999.0}, 10.0, When::Always, Member{&P::ramp_down_time}, Output::No, "RFG ramp-down time", "ramp from p1082 to zero, also for OFF1"},
    Row{1122, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Stored{}, Output::No, "BI: bypass RFG", ""},
    Row{1130, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, Member{&P::initial_rounding}, Output::No, "RFG initial rounding time", "with p1115 = 1"},
    Row{1131, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, Member{&P::final_rounding}, Output::No, "RFG final rounding time", "with p1115 = 1"},
    Row{1134, 1, kAxes, I16, Unit::None, {0.0, 1.0}, 0.0, When::Always, Member{&P::rounding_type}, Output::No, "RFG rounding type", "0 continuous, 1 discontinuous"},
    Row{1135, 1, kServo, F32, Unit::Seconds, {0.0, 600.0}, 0.0, When::Always, Member{&P::off3_ramp_down_time}, Output::No, "OFF3 ramp-down time", "ramp of OFF3; 0 brakes at the torque limit"},
    Row{1135, 1, kVector, F32, Unit::Seconds, {0.0, 600.0}, 3.0, When::Always, Member{&P::off3_ramp_down_time}, Output::No, "OFF3 ramp-down time", "ramp of OFF3; 0 brakes at the torque limit"},
    Row{1136, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, Member{&P::off3_initial_rounding}, Output::No, "OFF3 initial rounding time", "with p1115 = 1"},
    Row{1137, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, Member{&P::off3_final_rounding}, Output::No, "OFF3 final rounding time", "with p1115 = 1"},
    Row{1140, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: enable RFG", ""},
    Row{1141, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: continue RFG", ""},
    Row{1142, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, Stored{}, Output::No, "BI: enable setpoint", ""},
    Row{1149, 1, kAxes, F32, Unit::RevolutionsPerSecondSquared, kWhole, 0.0, When::ReadOnly, axis(axis_value::ramp_acceleration), Output::Connector, "RFG acceleration", ""},
};
// clang-format on

}  // namespace drive::rows
