#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/setpoint_channel/setpoint_channel.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/positioner_connections.hpp"

namespace drive::rows {

// clang-format off
/// What an axis without extended setpoint channel has too.
inline constexpr std::array kSpeedLimitRows{
    Row{1082, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, factory::motor_maximum_speed, When::QuickReady, setting<&SetpointChannel::Settings::maximum_speed>, Output::No, "Maximum speed", "highest speed setpoint; p1120, p1121 and p1135 count from it"},
    Row{1083, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 210000.0, When::Always, setting<&SetpointChannel::Settings::speed_limit_positive>, Output::Connector, "Speed limit positive", "limits the setpoint and F07901"},
    Row{1085, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(1083, 0), When::Always, value_input<&SetpointChannel::Inputs::forward_limit>(Quantity::Speed), Output::No, "CI: speed limit positive direction", "limits the setpoint and F07901"},
    Row{1086, 1, kAxes, F32, Unit::Rpm, {-210000.0, 0.0}, -210000.0, When::Always, setting<&SetpointChannel::Settings::speed_limit_negative>, Output::Connector, "Speed limit negative", "limits the setpoint and F07901"},
    Row{1088, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(1086, 0), When::Always, value_input<&SetpointChannel::Inputs::backward_limit>(Quantity::Speed), Output::No, "CI: speed limit negative direction", "limits the setpoint and F07901"},
    Row{1121, 1, kAxes, F32, Unit::Seconds, {0.0, 999999.0}, 10.0, When::Always, setting<&SetpointChannel::Settings::ramp_down_time>, Output::No, "RFG ramp-down time", "ramp from p1082 to zero, also for OFF1"},
    Row{1135, 1, kServo, F32, Unit::Seconds, {0.0, 600.0}, 0.0, When::Always, setting<&SetpointChannel::Settings::off3_ramp_down_time>, Output::No, "OFF3 ramp-down time", "ramp of OFF3; 0 brakes at the torque limit"},
    Row{1135, 1, kVector, F32, Unit::Seconds, {0.0, 600.0}, 3.0, When::Always, setting<&SetpointChannel::Settings::off3_ramp_down_time>, Output::No, "OFF3 ramp-down time", "ramp of OFF3; 0 brakes at the torque limit"},
    Row{1136, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, setting<&SetpointChannel::Settings::off3_initial_rounding>, Output::No, "OFF3 initial rounding time", "with p1115 = 1"},
    Row{1137, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, setting<&SetpointChannel::Settings::off3_final_rounding>, Output::No, "OFF3 final rounding time", "with p1115 = 1"},
    Row{1155, 1, kAxes, ConnectorInput, Unit::None, kWhole, factory::speed_setpoint, When::Always, value_input<&SetpointChannel::Inputs::speed_setpoint_1>(Quantity::Speed), Output::No, "CI: speed controller setpoint 1", "speed setpoint behind the ramp; delivered on an axis without extended setpoint channel: 60FFh, in velocity mode 6042h"},
    Row{1170, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::speed_demand>, Output::Connector, "Speed controller setpoint sum", "behind the ramp"},
};
template <>
inline constexpr auto rows_of<SetpointChannel> = joined(kSpeedLimitRows, with_module(function_module::kSetpointChannel, std::array{
    Row{1000, 1, kAxes, U32, Unit::None, {0.0, 999999.0}, 0.0, When::Always, Stored{"macros of connector inputs"}, Output::No, "Macro connector inputs speed setpoint", ""},
    Row{1001, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 1>, Output::Connector, "Fixed speed setpoint 1", "r1024 when p1020 to p1023 select it"},
    Row{1002, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 2>, Output::Connector, "Fixed speed setpoint 2", "r1024 when p1020 to p1023 select it"},
    Row{1003, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 3>, Output::Connector, "Fixed speed setpoint 3", "r1024 when p1020 to p1023 select it"},
    Row{1004, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 4>, Output::Connector, "Fixed speed setpoint 4", "r1024 when p1020 to p1023 select it"},
    Row{1005, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 5>, Output::Connector, "Fixed speed setpoint 5", "r1024 when p1020 to p1023 select it"},
    Row{1006, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 6>, Output::Connector, "Fixed speed setpoint 6", "r1024 when p1020 to p1023 select it"},
    Row{1007, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 7>, Output::Connector, "Fixed speed setpoint 7", "r1024 when p1020 to p1023 select it"},
    Row{1008, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 8>, Output::Connector, "Fixed speed setpoint 8", "r1024 when p1020 to p1023 select it"},
    Row{1009, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 9>, Output::Connector, "Fixed speed setpoint 9", "r1024 when p1020 to p1023 select it"},
    Row{1010, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 10>, Output::Connector, "Fixed speed setpoint 10", "r1024 when p1020 to p1023 select it"},
    Row{1011, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 11>, Output::Connector, "Fixed speed setpoint 11", "r1024 when p1020 to p1023 select it"},
    Row{1012, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 12>, Output::Connector, "Fixed speed setpoint 12", "r1024 when p1020 to p1023 select it"},
    Row{1013, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 13>, Output::Connector, "Fixed speed setpoint 13", "r1024 when p1020 to p1023 select it"},
    Row{1014, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 14>, Output::Connector, "Fixed speed setpoint 14", "r1024 when p1020 to p1023 select it"},
    Row{1015, 1, kAxes, F32, Unit::Rpm, {-210000.0, 210000.0}, 0.0, When::Always, slot_given<&SetpointChannel::Settings::fixed, 15>, Output::Connector, "Fixed speed setpoint 15", "r1024 when p1020 to p1023 select it"},
    Row{1020, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::fixed_setpoint_bit_0>, Output::No, "BI: fixed speed setpoint selection bit 0", "number of the fixed setpoint in r1024"},
    Row{1021, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::fixed_setpoint_bit_1>, Output::No, "BI: fixed speed setpoint selection bit 1", "number of the fixed setpoint in r1024"},
    Row{1022, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::fixed_setpoint_bit_2>, Output::No, "BI: fixed speed setpoint selection bit 2", "number of the fixed setpoint in r1024"},
    Row{1023, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::fixed_setpoint_bit_3>, Output::No, "BI: fixed speed setpoint selection bit 3", "number of the fixed setpoint in r1024"},
    Row{1024, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::fixed_setpoint>, Output::Connector, "Fixed speed setpoint effective", ""},
    Row{1070, 1, kAxes, ConnectorInput, Unit::None, kWhole, factory::main_setpoint, When::Always, value_input<&SetpointChannel::Inputs::main_setpoint>(Quantity::Speed), Output::No, "CI: main setpoint", "speed setpoint in front of the ramp; delivered: 60FFh, in velocity mode 6042h"},
    Row{1075, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&SetpointChannel::Inputs::supplementary_setpoint>(Quantity::Speed), Output::No, "CI: supplementary setpoint", "added to p1070"},
    Row{1078, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::setpoint_sum>, Output::Connector, "Total setpoint effective", ""},
    Row{1080, 1, kAxes, F32, Unit::Rpm, {0.0, 19500.0}, 0.0, When::Always, setting<&SetpointChannel::Settings::minimum_speed>, Output::No, "Minimum speed", "lowest speed setpoint besides no setpoint enable"},
    Row{1110, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::inhibit_negative>, Output::No, "BI: inhibit negative direction", "1 lets no negative setpoint through"},
    Row{1111, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::inhibit_positive>, Output::No, "BI: inhibit positive direction", "1 lets no positive setpoint through"},
    Row{1113, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::invert_setpoint>, Output::No, "BI: setpoint inversion", "1 reverses the setpoint"},
    Row{1114, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::directed_setpoint>, Output::Connector, "Setpoint after the direction limiting", ""},
    Row{1115, 1, kServo, I16, Unit::None, {0.0, 1.0}, 0.0, When::Ready, setting<&SetpointChannel::Settings::ramp_selection>, Output::No, "Ramp-function generator selection", "1 rounds the ends of the ramp"},
    Row{1115, 1, kVector, I16, Unit::None, {0.0, 1.0}, 1.0, When::Ready, setting<&SetpointChannel::Settings::ramp_selection>, Output::No, "Ramp-function generator selection", "1 rounds the ends of the ramp"},
    Row{1119, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::ramp_input>, Output::Connector, "RFG setpoint at input", ""},
    Row{1120, 1, kAxes, F32, Unit::Seconds, {0.0, 999999.0}, 10.0, When::Always, setting<&SetpointChannel::Settings::ramp_up_time>, Output::No, "RFG ramp-up time", "ramp from zero to p1082"},
    Row{1122, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::bypass_ramp>, Output::No, "BI: bypass RFG", "1 leaves no ramp"},
    Row{1130, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, setting<&SetpointChannel::Settings::initial_rounding>, Output::No, "RFG initial rounding time", "with p1115 = 1"},
    Row{1131, 1, kAxes, F32, Unit::Seconds, {0.0, 30.0}, 0.0, When::Always, setting<&SetpointChannel::Settings::final_rounding>, Output::No, "RFG final rounding time", "with p1115 = 1"},
    Row{1134, 1, kAxes, I16, Unit::None, {0.0, 1.0}, 0.0, When::Always, setting<&SetpointChannel::Settings::rounding_type>, Output::No, "RFG rounding type", "0 continuous, 1 discontinuous"},
    Row{1140, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SetpointChannel::Inputs::enable_ramp>, Output::No, "BI: enable RFG", "0 sets the output of the ramp to zero"},
    Row{1141, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SetpointChannel::Inputs::continue_ramp>, Output::No, "BI: continue RFG", "0 freezes the ramp"},
    Row{1142, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SetpointChannel::Inputs::enable_setpoint>, Output::No, "BI: enable setpoint", "0 sets the input of the ramp to zero"},
    Row{1143, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&SetpointChannel::Inputs::set_ramp>, Output::No, "BI: RFG accept setting value", "1 sets the output of the ramp to p1144"},
    Row{1144, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&SetpointChannel::Inputs::ramp_setting>(Quantity::Speed), Output::No, "CI: RFG setting value", "output of the ramp while p1143 = 1"},
    Row{1149, 1, kAxes, F32, Unit::RevolutionsPerSecondSquared, kWhole, 0.0, When::ReadOnly, shown<axis_value::ramp_acceleration>, Output::Connector, "RFG acceleration", ""},
    Row{1150, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, shown<axis_value::ramp_output>, Output::Connector, "RFG setpoint at the output", ""},
}));
template <>
inline constexpr auto rows_of<SpeedSetpoint2> = std::array{
    Row{1160, 1, kAxes, ConnectorInput, Unit::None, kWhole, factory::positioner_connection<1160>, When::Always, value_input<&SpeedSetpoint2::Inputs::speed>(Quantity::Speed), Output::No, "CI: speed controller setpoint 2", "speed setpoint behind the ramp; delivered on an axis with positioner: r2562"},
};
// clang-format on

}  // namespace drive::rows
