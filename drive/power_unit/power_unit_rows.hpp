#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/power_unit/power_unit.hpp"
#include "drive/values/axis_values.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<PowerUnit> = std::array{
    Row{25, 1, kAxes, F32, Unit::VoltsRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::output_voltage>, Output::Connector, "Output voltage smoothed", ""},
    Row{26, 1, kAxes, F32, Unit::Volts, kWhole, 600.0, When::ReadOnly, shown<axis_value::dc_voltage>, Output::Connector, "DC link voltage smoothed", ""},
    Row{27, 1, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::current>, Output::Connector, "Absolute current smoothed", ""},
    Row{28, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, shown<axis_value::modulation_depth>, Output::Connector, "Modulation depth smoothed", "of the highest voltage without overmodulation"},
    Row{36, 1, kAxes, F32, Unit::Percent, kWhole, 0.0, When::ReadOnly, shown<axis_value::overload>, Output::Connector, "Power unit overload I2t", ""},
    Row{37, 20, kAxes, F32, Unit::Celsius, kWhole, 30.0, When::ReadOnly, shown<axis_value::power_unit_temperature>, Output::Connector, "Power unit temperatures", "[0] heat sink, [1] chip; others the air"},
    Row{39, 3, kAxes, F32, Unit::KilowattHours, kWhole, 0.0, When::ReadOnly, shown<axis_value::energy>, Output::Connector, "Energy display: balance, drawn, fed back", "[0] balance, [1] drawn, [2] fed back at the motor terminals; a power cut keeps them"},
    Row{42, 3, kAxes, I32, Unit::WattHours, kWhole, 0.0, When::ReadOnly, shown<axis_value::process_energy>, Output::Connector, "Process energy display", "as r0039"},
    Row{67, 2, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::maximum_current>, Output::Connector, "Maximum drive output current", "[0] of all limits, [1] of the power unit"},
    Row{68, 2, kAxes, F32, Unit::AmperesRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::current>, Output::Connector, "Absolute current actual value", "both indices"},
    Row{69, 7, kAxes, F32, Unit::Amperes, kWhole, 0.0, When::ReadOnly, shown<axis_value::phase_current>, Output::Connector, "Phase current actual values", "[0..2] phases U, V, W; others 0"},
    Row{70, 1, kAxes, F32, Unit::Volts, kWhole, 600.0, When::ReadOnly, shown<axis_value::dc_voltage>, Output::Connector, "DC link voltage actual value", ""},
    Row{72, 1, kAxes, F32, Unit::VoltsRms, kWhole, 0.0, When::ReadOnly, shown<axis_value::output_voltage>, Output::Connector, "Output voltage", ""},
};
// clang-format on

}  // namespace drive::rows
