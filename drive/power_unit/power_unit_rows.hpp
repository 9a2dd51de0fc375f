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
    Row{200, 1, kAxes, U16, Unit::None, kWhole, 10000.0, When::ReadOnly, Fixed{10000.0, "code numbers of power units; the configuration gives the power unit"}, Output::No, "Power unit current code number", ""},
    Row{201, 1, kAxes, U16, Unit::None, {0.0, 65535.0}, 10000.0, When::Ready, Stored{"code numbers of power units; the configuration gives the power unit"}, Output::No, "Power unit code number", ""},
    Row{206, 5, kAxes, F32, Unit::Kilowatts, kWhole, 0.0, When::ReadOnly, shown<axis_value::rated_power>, Output::No, "Rated power unit power", "of a unit of the series with this rated current, every index"},
    Row{2170, 1, kAxes, F32, Unit::AmperesRms, {0.0, 10000.0}, 0.0, When::Always, setting<&PowerUnit::Settings::current_threshold>, Output::No, "Current threshold", "bit 3 of r0053"},
    Row{2172, 1, kAxes, F32, Unit::Volts, {0.0, 2000.0}, 800.0, When::Always, setting<&PowerUnit::Settings::link_threshold>, Output::No, "DC link voltage threshold", "bits 7 and 8 of r0053"},
    Row{7841, 16, kAxes, U8, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::serial_number>, Output::No, "Power unit serial number", "characters: AXSIM, then the number of the drive object"},
};
// clang-format on

}  // namespace drive::rows
