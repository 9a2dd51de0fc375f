#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/torque/torque_setpoint.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/positioner_connections.hpp"

namespace drive::rows {

// clang-format off
template <>
inline constexpr auto rows_of<TorqueSetpoint> = std::array{
    Row{1503, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(8850, 3), When::Always, value_input<&TorqueSetpoint::Inputs::setpoint>(Quantity::Torque), Output::No, "CI: torque setpoint (torque control)", "torque setpoint of torque control; delivered: 6071h"},
    Row{1508, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, shown<axis_value::torque_demand>, Output::Connector, "Torque setpoint before supplementary torque", ""},
    Row{1511, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&TorqueSetpoint::Inputs::supplementary_1>(Quantity::Torque), Output::No, "CI: supplementary torque 1", "added to the torque setpoint"},
    Row{1513, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&TorqueSetpoint::Inputs::supplementary_2>(Quantity::Torque), Output::No, "CI: supplementary torque 2", "added to the torque setpoint"},
    Row{1520, 1, kAxes, F32, Unit::NewtonMetre, {-1000000.0, 20000000.0}, factory::upper_torque_limit, When::Always, setting<&TorqueSetpoint::Settings::upper_limit>, Output::Connector, "Torque limit upper/motoring", "not above what the motor can"},
    Row{1521, 1, kAxes, F32, Unit::NewtonMetre, {-20000000.0, 1000000.0}, factory::lower_torque_limit, When::Always, setting<&TorqueSetpoint::Settings::lower_limit>, Output::Connector, "Torque limit lower/regenerative", "not below what the motor can"},
    Row{1522, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(1520, 0), When::Always, value_input<&TorqueSetpoint::Inputs::upper_limit>(Quantity::Torque), Output::No, "CI: torque limit upper", "upper torque limit"},
    Row{1523, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(1521, 0), When::Always, value_input<&TorqueSetpoint::Inputs::lower_limit>(Quantity::Torque), Output::No, "CI: torque limit lower", "lower torque limit"},
    Row{1538, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, shown<axis_value::upper_torque_limit>, Output::Connector, "Upper effective torque limit", ""},
    Row{1539, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, shown<axis_value::lower_torque_limit>, Output::Connector, "Lower effective torque limit", ""},
    Row{1542, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, value_input<&TorqueSetpoint::Inputs::reduction>(Quantity::Share), Output::No, "CI: travel to fixed stop torque reduction MOMRED", "both torque limits: less by this share of p1544; an unsigned word"},
    Row{1544, 1, kAxes, F32, Unit::Percent, {0.0, 65535.0}, 100.0, When::Always, setting<&TorqueSetpoint::Settings::reduction_weight>, Output::No, "Travel to fixed stop evaluation torque reduction", "what 100 % at p1542 take off the torque limits"},
    Row{1545, 1, kAxes, BinectorInput, Unit::None, kWhole, factory::positioner_connection<1545>, When::Always, bit_input<&TorqueSetpoint::Inputs::travels_to_fixed_stop>, Output::No, "BI: travel to fixed stop", "a motor that stands at its torque limit is not blocked (F07900)"},
    Row{1552, 1, kAxes, ConnectorInput, Unit::None, kWhole, 1.0, When::Always, value_input<&TorqueSetpoint::Inputs::upper_scaling>(Quantity::Share), Output::No, "CI: torque limit upper scaling without offset", "upper torque limit, of which it is the share that holds; an unsigned word"},
    Row{1554, 1, kAxes, ConnectorInput, Unit::None, kWhole, 1.0, When::Always, value_input<&TorqueSetpoint::Inputs::lower_scaling>(Quantity::Share), Output::No, "CI: torque limit lower scaling without offset", "lower torque limit, of which it is the share that holds; an unsigned word"},
    Row{2194, 1, kAxes, F32, Unit::Percent, {0.0, 100.0}, 90.0, When::Always, setting<&TorqueSetpoint::Settings::threshold>, Output::No, "Torque utilisation threshold", "r2199.11 below it"},
};
// clang-format on

}  // namespace drive::rows
