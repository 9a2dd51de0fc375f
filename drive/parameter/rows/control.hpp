#pragma once

#include <array>

#include "drive/parameter/axis_values.hpp"
#include "drive/parameter/factory_values.hpp"
#include "drive/parameter/row.hpp"

namespace drive::rows {

/// Closed-loop control, references.
// clang-format off
inline constexpr std::array kControlRows{
    Row{1155, 1, kAxes, ConnectorInput, Unit::None, kWhole, factory::speed_setpoint, When::Always, Slot{}, Output::No, "CI: speed controller setpoint 1", "speed setpoint behind the ramp; delivered on an axis without extended setpoint channel: 60FFh, in velocity mode 6042h"},
    Row{1160, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Slot{}, Output::No, "CI: speed controller setpoint 2", "speed setpoint behind the ramp"},
    Row{1170, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_demand), Output::Connector, "Speed controller setpoint sum", "behind the ramp"},
    Row{1215, 1, kAxes, I16, Unit::None, {0.0, 3.0}, factory::brake_configuration, When::Ready, Member{&P::brake_configuration}, Output::No, "Motor holding brake configuration", "0 none, 1 and 3 by the sequence control, 2 always open"},
    Row{1216, 1, kAxes, F32, Unit::Milliseconds, {0.0, 10000.0}, factory::brake_opening_time, When::Always, Member{&P::brake_opening_time}, Output::No, "Motor holding brake opening time", "the setpoint waits so long after the pulses have come"},
    Row{1217, 1, kAxes, F32, Unit::Milliseconds, {0.0, 10000.0}, factory::brake_closing_time, When::Always, Member{&P::brake_closing_time}, Output::No, "Motor holding brake closing time", "the motor holds so long after the brake was told to close"},
    Row{1226, 1, kAxes, F32, Unit::Rpm, {0.0, 210000.0}, 20.0, When::Always, Member{&P::standstill_threshold}, Output::No, "Standstill speed threshold", "end of the braking of OFF1 and OFF3"},
    Row{1227, 1, kAxes, F32, Unit::Seconds, {0.0, 300.0}, 4.0, When::Always, Member{&P::standstill_monitoring_time}, Output::No, "Standstill monitoring time", "longest wait for p1226"},
    Row{1228, 1, kAxes, F32, Unit::Seconds, {0.0, 299.0}, 0.01, When::Always, Member{&P::pulse_suppression_delay}, Output::No, "Pulse suppression delay", "pulses stay on so long after standstill"},
    Row{1300, 1, kServo, I16, Unit::None, {20.0, 23.0}, 21.0, When::QuickReady, Member{&P::control_mode}, Output::No, "Open/closed-loop control mode", "0 to 19 V/f, 20 and 22 without encoder, 21 and 23 with it"},
    Row{1300, 1, kVector, I16, Unit::None, {0.0, 23.0}, 20.0, When::QuickReady, Member{&P::control_mode}, Output::No, "Open/closed-loop control mode", "0 to 19 V/f, 20 and 22 without encoder, 21 and 23 with it"},
    Row{1406, 1, kAxes, U16, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_controller_control), Output::Both, "Control word speed controller", "bit 12: torque control by p1501"},
    Row{1407, 1, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_controller_status), Output::Both, "Status word speed controller", "bits 0 V/f, 1 without encoder, 2 torque control, 3 speed control, 7 torque limit reached"},
    Row{1438, 1, kAxes, F32, Unit::Rpm, kWhole, 0.0, When::ReadOnly, axis(axis_value::speed_demand), Output::Connector, "Speed controller speed setpoint", ""},
    Row{1441, 1, kAxes, F32, Unit::Milliseconds, {0.0, 50.0}, 0.0, When::Always, Member{&P::speed_smoothing}, Output::No, "Actual speed smoothing time", "of what the speed controller sees"},
    Row{1460, 1, kAxes, F32, Unit::NewtonMetreSecondPerRadian, {0.0, 999999.0}, factory::speed_gain, When::Always, Member{&P::speed_gain}, Output::No, "Speed controller P gain", "gain of the speed controller"},
    Row{1462, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, factory::speed_integral_time, When::Always, Member{&P::speed_integral_time}, Output::No, "Speed controller integral time", "0 = no integral part"},
    Row{1470, 1, kAxes, F32, Unit::NewtonMetreSecondPerRadian, {0.0, 999999.0}, factory::encoderless_speed_gain, When::Always, Member{&P::encoderless_speed_gain}, Output::No, "Speed controller P gain encoderless", "as p1460, without encoder"},
    Row{1472, 1, kAxes, F32, Unit::Milliseconds, {0.0, 100000.0}, factory::encoderless_speed_integral_time, When::Always, Member{&P::encoderless_speed_integral_time}, Output::No, "Speed controller integral time encoderless", "as p1462, without encoder"},
    Row{1496, 1, kAxes, F32, Unit::Percent, {0.0, 10000.0}, 0.0, When::Always, Member{&P::acceleration_precontrol}, Output::No, "Acceleration precontrol scaling", "torque for the ramp from p0341 and p0342; p1960 sets it to 100 % with the inertia that it has found"},
    Row{1501, 1, kAxes, BinectorInput, Unit::None, kWhole, 0.0, When::Always, Slot{}, Output::No, "BI: changeover speed/torque control", "1 changes from speed to torque control (p1300 = 21)"},
    Row{1503, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(8850, 3), When::Always, Slot{}, Output::No, "CI: torque setpoint (torque control)", "torque setpoint of torque control; delivered: 6071h"},
    Row{1508, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, axis(axis_value::torque_demand), Output::Connector, "Torque setpoint before supplementary torque", ""},
    Row{1511, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Slot{}, Output::No, "CI: supplementary torque 1", "added to the torque setpoint"},
    Row{1513, 1, kAxes, ConnectorInput, Unit::None, kWhole, 0.0, When::Always, Slot{}, Output::No, "CI: supplementary torque 2", "added to the torque setpoint"},
    Row{1520, 1, kAxes, F32, Unit::NewtonMetre, {-1000000.0, 20000000.0}, factory::upper_torque_limit, When::Always, Member{&P::upper_torque_limit}, Output::Connector, "Torque limit upper/motoring", "not above what the motor can"},
    Row{1521, 1, kAxes, F32, Unit::NewtonMetre, {-20000000.0, 1000000.0}, factory::lower_torque_limit, When::Always, Member{&P::lower_torque_limit}, Output::Connector, "Torque limit lower/regenerative", "not below what the motor can"},
    Row{1522, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(1520, 0), When::Always, Slot{}, Output::No, "CI: torque limit upper", "upper torque limit"},
    Row{1523, 1, kAxes, ConnectorInput, Unit::None, kWhole, own_source(1521, 0), When::Always, Slot{}, Output::No, "CI: torque limit lower", "lower torque limit"},
    Row{1530, 1, kAxes, F32, Unit::Kilowatts, {0.0, 100000.0}, factory::motoring_power_limit, When::Always, Member{&P::motoring_power_limit}, Output::No, "Power limit motoring", "limits the torque"},
    Row{1531, 1, kAxes, F32, Unit::Kilowatts, {-100000.0, -0.01}, factory::regenerative_power_limit, When::Always, Member{&P::regenerative_power_limit}, Output::No, "Power limit regenerative", "limits the torque"},
    Row{1538, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, axis(axis_value::upper_torque_limit), Output::Connector, "Upper effective torque limit", ""},
    Row{1539, 1, kAxes, F32, Unit::NewtonMetre, kWhole, 0.0, When::ReadOnly, axis(axis_value::lower_torque_limit), Output::Connector, "Lower effective torque limit", ""},
    Row{1800, 1, kAxes, F32, Unit::Kilohertz, {0.5, 16.0}, 4.0, When::Always, Stored{until::kPulses}, Output::No, "Pulse frequency setpoint", ""},
    Row{1801, 1, kServo, F32, Unit::Kilohertz, kWhole, 4.0, When::ReadOnly, Fixed{4.0, until::kPulses}, Output::Connector, "Pulse frequency actual", ""},
    Row{1801, 2, kVector, F32, Unit::Kilohertz, kWhole, 4.0, When::ReadOnly, Fixed{4.0, until::kPulses}, Output::Connector, "Pulse frequency actual", ""},
    Row{2000, 1, kAxes, F32, Unit::Rpm, {6.0, 210000.0}, factory::rated_speed, When::Ready, Member{&P::reference_speed}, Output::No, "Reference speed", "100 % of a speed in process data"},
    Row{2001, 1, kAxes, F32, Unit::VoltsRms, {10.0, 100000.0}, 1000.0, When::Ready, Slot{}, Output::No, "Reference voltage", "voltages in process data, of which it is 100 %"},
    Row{2002, 1, kAxes, F32, Unit::AmperesRms, {0.1, 100000.0}, 100.0, When::Ready, Slot{}, Output::No, "Reference current", "currents in process data, of which it is 100 %"},
    Row{2003, 1, kAxes, F32, Unit::NewtonMetre, {0.01, 20000000.0}, factory::rated_torque, When::Ready, Member{&P::reference_torque}, Output::No, "Reference torque", "100 % of a torque in process data"},
    Row{2004, 1, kAxes, F32, Unit::Kilowatts, kWhole, 0.0, When::ReadOnly, axis(axis_value::reference_power), Output::No, "Reference power", "p2003 times p2000"},
    Row{2005, 1, kAxes, F32, Unit::Degrees, {90.0, 180.0}, 90.0, When::Ready, Stored{"a connector that is an angle in degrees"}, Output::No, "Reference angle", ""},
    Row{2006, 1, kAxes, F32, Unit::Celsius, {50.0, 300.0}, 100.0, When::Ready, Slot{}, Output::No, "Reference temperature", "temperatures in process data, of which it is 100 %"},
    Row{2007, 1, kAxes, F32, Unit::RevolutionsPerSecondSquared, {0.01, 500000.0}, 0.01, When::Ready, Slot{}, Output::No, "Reference acceleration", "accelerations in process data, of which it is 100 %"},
};
// clang-format on

}  // namespace drive::rows
