#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/positioning/control/position_control.hpp"
#include "drive/values/positioner_connections.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<PositionControl> = std::array{
    Row{2530, 1, kAxes, ConnectorInput, Unit::None, kWhole, factory::positioner_connection<2530>, When::Always, value_input<&PositionControl::Inputs::setpoint>(Quantity::Length), Output::No, "CI: LR position setpoint", "r2556"},
    Row{2531, 1, kAxes, ConnectorInput, Unit::None, kWhole, factory::positioner_connection<2531>, When::Always, value_input<&PositionControl::Inputs::velocity>(Quantity::LengthVelocity), Output::No, "CI: LR velocity setpoint", "r2561"},
    Row{2532, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(2521, 0), When::Always, value_input<&PositionControl::Inputs::actual_position>(Quantity::Length), Output::No, "CI: LR position actual value", "r2557"},
    Row{2533, 1, kAxes, F32, Unit::Milliseconds, {0.0, 1000.0}, 0.0, When::Always, setting<&PositionControl::Settings::smoothing_time>, Output::No, "LR position setpoint filter time constant", ""},
    Row{2534, 1, kAxes, F32, Unit::Percent, {0.0, 200.0}, 0.0, When::Always, setting<&PositionControl::Settings::precontrol>, Output::No, "LR velocity precontrol factor", ""},
    Row{2535, 1, kAxes, F32, Unit::None, {0.0, 2.0}, 0.0, When::Always, setting<&PositionControl::Settings::balancing_dead_time>, Output::No, "LR precontrol balancing filter dead time", ""},
    Row{2536, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100.0}, 0.0, When::Always, setting<&PositionControl::Settings::balancing_time>, Output::No, "LR precontrol balancing filter PT1", ""},
    Row{2537, 1, kAxes, ConnectorInput, Unit::None, kWhole, 1.0, When::Always, value_input<&PositionControl::Inputs::gain_share>(Quantity::Share), Output::No, "CI: LR position controller gain adaptation", "r2558"},
    Row{2538, 1, kAxes, F32, Unit::ThousandPerMinute, {0.0, 300.0}, 1.0, When::Always, setting<&PositionControl::Settings::gain>, Output::No, "LR proportional gain (Kv)", ""},
    Row{2539, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, 0.0, When::Always, setting<&PositionControl::Settings::integral_time>, Output::No, "LR integral time", ""},
    Row{2540, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 210000.0, When::Always, setting<&PositionControl::Settings::output_limit>, Output::Connector, "LR position controller output limit", ""},
    Row{2541, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(2540, 0), When::Always, value_input<&PositionControl::Inputs::output_limit>(Quantity::Speed), Output::No, "CI: LR position controller output limit source", "r2560"},
    Row{2542, 1, kAxes, U32, Unit::LengthUnits, {0.0, 2147483647.0}, 200.0, When::Always, setting<&PositionControl::Settings::standstill_window>, Output::No, "LR standstill window", ""},
    Row{2543, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, 200.0, When::Always, setting<&PositionControl::Settings::standstill_time>, Output::No, "LR standstill monitoring time", ""},
    Row{2544, 1, kAxes, U32, Unit::LengthUnits, {0.0, 2147483647.0}, 40.0, When::Always, setting<&PositionControl::Settings::positioning_window>, Output::No, "LR positioning window", ""},
    Row{2545, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, 1000.0, When::Always, setting<&PositionControl::Settings::positioning_time>, Output::No, "LR positioning monitoring time", ""},
    Row{2546, 1, kAxes, U32, Unit::LengthUnits, {0.0, 2147483647.0}, 1000.0, When::Always, setting<&PositionControl::Settings::following_error_tolerance>, Output::No, "LR following error tolerance", ""},
    Row{2547, 1, kAxes, I32, Unit::LengthUnits, {-2147483648.0, 2147483647.0}, 0.0, When::Always, setting<&PositionControl::Settings::cam_1>, Output::No, "LR cam switching position 1", ""},
    Row{2548, 1, kAxes, I32, Unit::LengthUnits, {-2147483648.0, 2147483647.0}, 0.0, When::Always, setting<&PositionControl::Settings::cam_2>, Output::No, "LR cam switching position 2", ""},
    Row{2549, 1, kAxes, BinectorInput, Unit::None, kWhole, own_source(899, 2), When::Always, bit_input<&PositionControl::Inputs::enable_1>, Output::No, "BI: LR enable 1", "r2526.3"},
    Row{2550, 1, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2550>, When::Always, bit_input<&PositionControl::Inputs::enable_2>, Output::No, "BI: LR enable 2", "r2526.3"},
    Row{2551, 1, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2551>, When::Always, bit_input<&PositionControl::Inputs::setpoint_fixed>, Output::No, "BI: LR setpoint fixed", "monitoring, r2526"},
    Row{2552, 1, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2552>, When::Always, bit_input<&PositionControl::Inputs::travels_to_fixed_stop>, Output::No, "BI: LR travel to fixed stop active", "monitoring, r2526"},
    Row{2553, 1, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2553>, When::Always, bit_input<&PositionControl::Inputs::fixed_stop_reached>, Output::No, "BI: LR fixed stop reached", "monitoring, r2526"},
    Row{2554, 1, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<2554>, When::Always, bit_input<&PositionControl::Inputs::has_task>, Output::No, "BI: LR traversing command active", "monitoring, r2526"},
    Row{2555, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(2524, 0), When::Always, value_input<&PositionControl::Inputs::units_per_revolution>(Quantity::Length), Output::No, "CI: LR LU per revolution", "r2558, r2561"},
    Row{2556, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, output<&PositionControl::setpoint>, Output::Connector, "LR position setpoint after smoothing", ""},
    Row{2557, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, output<&PositionControl::deviation>, Output::Connector, "LR position controller input deviation", ""},
    Row{2558, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, output<&PositionControl::proportional>, Output::Connector, "LR position controller P component", ""},
    Row{2559, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, output<&PositionControl::integral>, Output::Connector, "LR position controller I component", ""},
    Row{2560, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, output<&PositionControl::limited>, Output::Connector, "LR velocity setpoint after limit", ""},
    Row{2561, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, output<&PositionControl::precontrol>, Output::Connector, "LR velocity precontrol value", ""},
    Row{2562, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, output<&PositionControl::output>, Output::Connector, "LR total velocity setpoint", ""},
    Row{2563, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, output<&PositionControl::following_error>, Output::Connector, "LR following error dynamic model", ""},
    Row{2564, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, output<&PositionControl::torque_precontrol>, Output::Connector, "LR torque precontrol value", ""},
    Row{2565, 1, kAxes, I32, Unit::LengthUnits, kWhole, 0.0, When::ReadOnly, output<&PositionControl::deviation>, Output::Connector, "LR following error actual", ""},
    Row{2566, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, output<&PositionControl::setpoint_speed>, Output::Connector, "LR velocity at precontrol input", ""},
    Row{2567, 1, kAxes, F32, Unit::KilogramSquareMetre, {0.0, 100000.0}, 1.0, When::Always, setting<&PositionControl::Settings::inertia>, Output::No, "LR torque precontrol moment of inertia", ""},
};
// clang-format on

}  // namespace drive::rows
