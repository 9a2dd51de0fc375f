#pragma once

#include <array>

#include "drive/base/unit_inputs.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/infeed_values.hpp"

namespace drive::rows {

/// The infeed as a drive object.
// clang-format off
inline constexpr std::array kInfeedRows{
    Row{2, 1, kInfeed, I16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<infeed_value::operating_display>, Output::Connector, "Infeed operating display", "0 operation, 21 ready for operation, 31 give ON, 41 ON must be 0, 42 OFF2, 45 fault, 46 p0009, 70 run-up, 200 waits for the DC link"},
    Row{26, 1, kInfeed, F32, Unit::Volts, kWhole, 0.0, When::ReadOnly, shown<infeed_value::dc_voltage>, Output::Connector, "DC link voltage smoothed", ""},
    Row{70, 1, kInfeed, F32, Unit::Volts, kWhole, 0.0, When::ReadOnly, shown<infeed_value::dc_voltage>, Output::Connector, "DC link voltage actual value", ""},
    Row{840, 1, kInfeed, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&InfeedInputs::on>, Output::No, "BI: ON/OFF1", "ON command: the line contactor closes; 0 = OFF1"},
    Row{844, 1, kInfeed, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&InfeedInputs::no_off2>, Output::No, "BI: OFF2 source 1", "0 = OFF2"},
    Row{845, 1, kInfeed, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&InfeedInputs::no_off2_second>, Output::No, "BI: OFF2 source 2", "0 = OFF2"},
    Row{852, 1, kInfeed, BinectorInput, Unit::None, kWhole, 1.0, When::Always, bit_input<&InfeedInputs::enable_operation>, Output::No, "BI: enable operation", "0 ends the operation"},
    Row{857, 1, kInfeed, F32, Unit::Milliseconds, {100.0, 60000.0}, 6000.0, When::Always, Slot{}, Output::No, "Power unit monitoring time", "F07802 when the DC link has no voltage so long after ON"},
    Row{863, 1, kInfeed, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<infeed_value::coupling>, Output::Both, "Drive coupling status/control word", "bit 0 operates (for p0864 of the axes), bit 1 line contactor closed"},
    Row{898, 1, kInfeed, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<infeed_value::sequence_control>, Output::Both, "Control word sequence control", "bits 0, 1 and 3"},
    Row{899, 1, kInfeed, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<infeed_value::sequence_status>, Output::Both, "Status word sequence control", "bits 0 to 2, 4, 6, 9, 11 and 12"},
};
// clang-format on

}  // namespace drive::rows
