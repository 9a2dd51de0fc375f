#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/sequence_control/sequence_control.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/checks.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<SequenceControl> = std::array{
    Row{2, 1, kAxes, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::operating_display>, Output::Connector, "Drive operating display", "from state and controlword"},
    Row{10, 1, kAxes, I16, Unit::None, {0.0, 95.0}, 0.0, When::Ready, setting<&SequenceControl::Settings::commissioning>, Output::No, "Drive commissioning parameter filter", "not 0: switching on is inhibited (r0002 = 46); C(n) parameters can be written", Keep::No, check::drive_filter},
    Row{46, 1, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::missing_enables>, Output::Both, "Missing enable signals", ""},
    Row{840, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 0), When::Always, bit_input<&SequenceControl::Inputs::on>, Output::No, "BI: ON/OFF1", "ON command, 0 = OFF1"},
    Row{844, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 1), When::Always, bit_input<&SequenceControl::Inputs::no_off2>, Output::No, "BI: OFF2 source 1", "0 = OFF2"},
    Row{845, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SequenceControl::Inputs::no_off2_second>, Output::No, "BI: OFF2 source 2", "0 = OFF2"},
    Row{848, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 2), When::Always, bit_input<&SequenceControl::Inputs::no_off3>, Output::No, "BI: OFF3 source 1", "0 = OFF3"},
    Row{849, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SequenceControl::Inputs::no_off3_second>, Output::No, "BI: OFF3 source 2", "0 = OFF3"},
    Row{852, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(8890, 3), When::Always, bit_input<&SequenceControl::Inputs::enable_operation>, Output::No, "BI: enable operation", "0 takes the pulses off"},
    Row{854, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SequenceControl::Inputs::control_by_plc>, Output::No, "BI: control by PLC", "0 in operation raises F07220"},
    Row{857, 1, kAxes, F32, Unit::Milliseconds, {100.0, 60000.0}, 6000.0, When::Always, setting<&SequenceControl::Settings::power_monitoring_time>, Output::No, "Power unit monitoring time", "F07840 or F07802 when infeed or DC link do not come within it after ON"},
    Row{864, 1, kAxes, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&SequenceControl::Inputs::infeed_operates>, Output::No, "BI: infeed operation", "0 keeps the pulses off"},
    Row{898, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::sequence_control>, Output::Both, "Control word sequence control", ""},
    Row{899, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::sequence_status>, Output::Both, "Status word sequence control (ZSW1 source)", ""},
    Row{1226, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 20.0, When::Always, setting<&SequenceControl::Settings::standstill_threshold>, Output::No, "Standstill speed threshold", "end of the braking of OFF1 and OFF3"},
    Row{1227, 1, kAxes, F32, Unit::Seconds, {0.0, 300.0}, 4.0, When::Always, setting<&SequenceControl::Settings::standstill_monitoring_time>, Output::No, "Standstill monitoring time", "longest wait for p1226"},
    Row{1228, 1, kAxes, F32, Unit::Seconds, {0.0, 299.0}, 0.01, When::Always, setting<&SequenceControl::Settings::pulse_suppression_delay>, Output::No, "Pulse suppression delay", "pulses stay on so long after standstill"},
    Row{8641, 1, kAxes, I16, Unit::None, {0.0, 3.0}, 3.0, When::Ready, setting<&SequenceControl::Settings::abort_connection_option>, Output::No, "CAN abort connection option code", "reaction to F08700: 0 none, 1 OFF1, 2 OFF2, 3 OFF3"},
    Row{8791, 1, kAxes, I16, Unit::None, {-1.0, 3.0}, -1.0, When::Always, setting<&SequenceControl::Settings::halt_option>, Output::No, "CAN stop (halt) option code", "controlword bit 8: -1 no function, 0 pulses off, 1 stop on p1121, 2 on p1135, 3 at the torque limit"},
};
// clang-format on

}  // namespace drive::rows
