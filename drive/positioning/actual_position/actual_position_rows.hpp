#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/positioning/actual_position/actual_position.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/positioner_connections.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<ActualPosition> = std::array{
    Row{488, 3, kAxes, I16, Unit::None, {0.0, 8.0}, 0.0, When::Always, setting<&ActualPosition::Settings::probe_terminal_1>, Output::No, "Measuring probe 1 input terminal", ""},
    Row{489, 3, kAxes, I16, Unit::None, {0.0, 8.0}, 0.0, When::Always, setting<&ActualPosition::Settings::probe_terminal_2>, Output::No, "Measuring probe 2 input terminal", ""},
    Row{493, 3, kAxes, I16, Unit::None, {0.0, 8.0}, 0.0, When::Always, setting<&ActualPosition::Settings::mark_selection>, Output::No, "Zero mark selection input terminal", ""},
    Row{494, 3, kAxes, I16, Unit::None, {0.0, 8.0}, 0.0, When::Always, setting<&ActualPosition::Settings::equivalent_mark>, Output::No, "Equivalent zero mark input terminal", ""},
    Row{495, 3, kAxes, I16, Unit::None, {0.0, 8.0}, 0.0, When::Always, setting<&ActualPosition::Settings::equivalent_mark_2>, Output::No, "Equivalent zero mark input terminal", ""},
    Row{2502, 1, kAxes, I16, Unit::None, {0.0, 3.0}, 1.0, When::Ready, setting<&ActualPosition::Settings::encoder>, Output::No, "LR encoder assignment", ""},
    Row{2503, 1, kAxes, U32, Unit::LengthUnits, {1.0, 2147483647.0}, 10000.0, When::Ready, setting<&ActualPosition::Settings::units_per_10_mm>, Output::No, "LR LU per 10 mm (linear encoder)", ""},
    Row{2504, 1, kAxes, U32, Unit::None, {1.0, 1048576.0}, factory::gear_motor_revolutions, When::Ready, setting<&ActualPosition::Settings::gear_motor>, Output::No, "LR motor revolutions of gear ratio", ""},
    Row{2505, 1, kAxes, I32, Unit::None, {-1048576.0, 1048576.0}, factory::gear_load_revolutions, When::Ready, setting<&ActualPosition::Settings::gear_load>, Output::No, "LR load revolutions of gear ratio", ""},
    Row{2506, 1, kAxes, U32, Unit::LengthUnits, {1.0, 2147483647.0}, factory::units_per_load_revolution, When::Ready, setting<&ActualPosition::Settings::units_per_load>, Output::No, "LR LU per load revolution", ""},
    Row{2507, 1, kAxes, I16, Unit::None, {0.0, 3.0}, 1.0, When::Always, setting<&ActualPosition::Settings::adjustment>, Output::No, "LR absolute encoder adjustment status", "2 adjusts an absolute encoder to p2598"},
    Row{2508, 4, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2508>, When::Always, bit_input<&ActualPosition::Inputs::search_mark>, Output::No, "BI: LR activate reference mark search", "r2523, r2526"},
    Row{2509, 4, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2509>, When::Always, bit_input<&ActualPosition::Inputs::evaluate_probe>, Output::No, "BI: LR activate measuring probe evaluation", "r2523, r2526"},
    Row{2510, 4, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&ActualPosition::Inputs::second_probe>, Output::No, "BI: LR measuring probe selection", "r2523, r2526"},
    Row{2511, 4, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&ActualPosition::Inputs::falling_edge>, Output::No, "BI: LR measuring probe edge", "r2523, r2526"},
    Row{2512, 4, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2512>, When::Always, bit_input<&ActualPosition::Inputs::correct>, Output::No, "BI: LR activate corrective value (edge)", "r2521"},
    Row{2513, 4, kAxes, ConnectorInput, Unit::None, kWhole, factory::positioner_connection<2513>, When::Always, value_input<&ActualPosition::Inputs::correction>(Quantity::Length), Output::No, "CI: LR corrective value", "r2521, with an edge of p2512 or p2730"},
    Row{2514, 4, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&ActualPosition::Inputs::set_position>, Output::No, "BI: LR activate position actual value setting", "r2521 is p2515 while it is 1"},
    Row{2515, 4, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&ActualPosition::Inputs::setting_value>(Quantity::Length), Output::No, "CI: LR position setting value", "r2521"},
    Row{2516, 4, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&ActualPosition::Inputs::offset>(Quantity::Length), Output::No, "CI: LR position offset", "r2521"},
    Row{2517, 1, kAxes, I16, Unit::None, {0.0, 51.0}, 0.0, When::Always, setting<&ActualPosition::Settings::direct_probe_1>, Output::No, "LR direct measuring probe 1", ""},
    Row{2518, 1, kAxes, I16, Unit::None, {0.0, 51.0}, 0.0, When::Always, setting<&ActualPosition::Settings::direct_probe_2>, Output::No, "LR direct measuring probe 2", ""},
    Row{2519, 1, kAxes, I16, Unit::None, {0.0, 5.0}, 1.0, When::Always, Stored{"data sets; the unit has one"}, Output::No, "LR preprocessing reaction to DDS changeover", ""},
    Row{2520, 3, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "an interface to the encoder; its control bits are in the functions"}, Output::No, "LR encoder control word", ""},
    Row{2521, 4, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, output<&ActualPosition::position_of>, Output::Connector, "LR position actual value", "[0] of the position control, [1] of encoder 1"},
    Row{2522, 4, kAxes, I32, Unit::ThousandLengthUnitsPerMinute, kWhole, 0.0, When::ReadOnly, output<&ActualPosition::velocity_of>, Output::Connector, "LR velocity actual value", "as r2521"},
    Row{2523, 4, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, output<&ActualPosition::measured_of>, Output::Connector, "LR measured value", "[0]"},
    Row{2524, 1, kAxes, F32, Unit::LengthUnits, kWhole, 10000.0, When::ReadOnly, output<&ActualPosition::units_per_revolution>, Output::Connector, "LR LU per motor revolution", "p2506, p2505 and p2504"},
    Row{2525, 1, kAxes, U32, Unit::LengthUnits, {0.0, 4294967295.0}, 0.0, When::Always, setting<&ActualPosition::Settings::adjustment_offset>, Output::No, "LR encoder adjustment offset", ""},
    Row{2526, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::position_status>, Output::Both, "LR status word", ""},
    Row{2527, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::encoder_position_status<0>>, Output::Both, "LR actual value sensing status encoder 1", ""},
    Row{2528, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::encoder_position_status<1>>, Output::Both, "LR actual value sensing status encoder 2", ""},
    Row{2529, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::encoder_position_status<2>>, Output::Both, "LR actual value sensing status encoder 3", ""},
    Row{2583, 1, kAxes, I32, Unit::LengthUnits, {-200000.0, 200000.0}, 0.0, When::Always, setting<&ActualPosition::Settings::backlash>, Output::No, "EPOS backlash", ""},
    Row{2667, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, output<&ActualPosition::backlash_compensation>, Output::Connector, "EPOS backlash compensation value", ""},
    Row{2720, 1, kAxes, U32, Unit::None, {0.0, 7.0}, 0.0, When::Ready, Stored{"position tracking of a load gear"}, Output::No, "Load gear configuration", ""},
    Row{2721, 1, kAxes, U32, Unit::None, {0.0, 4194303.0}, 0.0, When::Ready, Stored{"position tracking of a load gear"}, Output::No, "Load gear virtual revolutions absolute encoder", ""},
    Row{2722, 1, kAxes, F32, Unit::None, {0.0, 4294967300.0}, 0.0, When::Ready, Stored{"position tracking of a load gear"}, Output::No, "Load gear position tracking tolerance window", ""},
    Row{2723, 3, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "position tracking of a load gear"}, Output::Connector, "Load gear absolute value", ""},
    Row{2724, 3, kAxes, I32, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "position tracking of a load gear"}, Output::Connector, "Load gear position difference", ""},
    Row{2730, 4, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, bit_input<&ActualPosition::Inputs::correct_negatively>, Output::No, "BI: LR activate negative corrective value (edge)", "r2521"},
    Row{2733, 1, kAxes, U8, Unit::None, {0.0, 255.0}, 0.0, When::Always, Stored{"data sets; the unit has one"}, Output::No, "LR encoder adjustment DDS", ""},
};
// clang-format on

}  // namespace drive::rows
