#pragma once

#include <array>

#include "drive/base/unit_inputs.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/terminal_values.hpp"

namespace drive::rows {

/// Inputs and outputs of the control unit.
// clang-format off
inline constexpr std::array kTerminalRows{
    Row{721, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<terminal_value::levels>, Output::Both, "CU digital inputs terminal value", "bits 0 to 7, 16, 17, 20, 21 DI, 8 to 15 DI/DO; 0 of an output"},
    Row{722, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<terminal_value::status>, Output::Both, "CU digital inputs status", "r0721 with the simulation of p0795"},
    Row{723, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<terminal_value::inverted_status>, Output::Both, "CU digital inputs status inverted", "r0722 inverted"},
    Row{728, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::Always, shown<terminal_value::directions, terminal_value::set_directions>, Output::No, "CU set input or output", "bits 8 to 15: 1 makes DI/DO 8 to 15 an output"},
    Row{738, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 0>, Output::No, "BI: CU signal source for terminal DI/DO 8", "r0747.8"},
    Row{739, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 1>, Output::No, "BI: CU signal source for terminal DI/DO 9", "r0747.9"},
    Row{740, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 2>, Output::No, "BI: CU signal source for terminal DI/DO 10", "r0747.10"},
    Row{741, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 3>, Output::No, "BI: CU signal source for terminal DI/DO 11", "r0747.11"},
    Row{742, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 4>, Output::No, "BI: CU signal source for terminal DI/DO 12", "r0747.12"},
    Row{743, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 5>, Output::No, "BI: CU signal source for terminal DI/DO 13", "r0747.13"},
    Row{744, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 6>, Output::No, "BI: CU signal source for terminal DI/DO 14", "r0747.14"},
    Row{745, 1, kControlUnit, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input_at<&TerminalInputs::outputs, 7>, Output::No, "BI: CU signal source for terminal DI/DO 15", "r0747.15"},
    Row{747, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<terminal_value::outputs>, Output::Both, "CU digital outputs status", "bits 8 to 15: p0738 to p0745, inverted by p0748, whatever p0728 says"},
    Row{748, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::Always, shown<terminal_value::inversions, terminal_value::set_inversions>, Output::No, "CU invert digital outputs", "bits 8 to 15 of r0747"},
    Row{752, 1, kControlUnit, F32, Unit::VoltsOrMilliamperes, kWhole, 0.0, When::ReadOnly, shown<terminal_value::analog>, Output::Connector, "CU analog input", "in V; 10 V are 100 %; 0 until something is connected, as a CU320-2 has no such input", Keep::Stored, nullptr, FullScale::AnalogInput},
    Row{795, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::Always, shown<terminal_value::simulated, terminal_value::set_simulated>, Output::No, "CU digital inputs simulation mode", "1: r0722 shows p0796 in place of the terminal", Keep::No},
    Row{796, 1, kControlUnit, U32, Unit::None, kWhole, 0.0, When::Always, shown<terminal_value::simulation, terminal_value::set_simulation>, Output::No, "CU digital inputs simulation mode setpoint", "by p0795", Keep::No},
};
// clang-format on

}  // namespace drive::rows
