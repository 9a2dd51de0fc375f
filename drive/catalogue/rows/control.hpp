#pragma once

#include <array>

#include "drive/base/references.hpp"
#include "drive/parameter/row.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::rows {

/// References of process data, and what no block of an axis acts on.
// clang-format off
inline constexpr std::array kControlRows{
    Row{1800, 1, kAxes, F32, Unit::Kilohertz, {0.5, 16.0}, 4.0, When::Always, Stored{until::kPulses}, Output::No, "Pulse frequency setpoint", ""},
    Row{1801, 1, kServo, F32, Unit::Kilohertz, kWhole, 4.0, When::ReadOnly, Fixed{4.0, until::kPulses}, Output::Connector, "Pulse frequency actual", ""},
    Row{1801, 2, kVector, F32, Unit::Kilohertz, kWhole, 4.0, When::ReadOnly, Fixed{4.0, until::kPulses}, Output::Connector, "Pulse frequency actual", ""},
    Row{2000, 1, kAxes, F32, Unit::Rpm, {6.0, 210000.0}, factory::rated_speed, When::Ready, setting<&ReferenceValues::speed>, Output::No, "Reference speed", "100 % of a speed in process data"},
    Row{2001, 1, kAxes, F32, Unit::VoltsRms, {10.0, 100000.0}, 1000.0, When::Ready, Slot{}, Output::No, "Reference voltage", "voltages in process data, of which it is 100 %"},
    Row{2002, 1, kAxes, F32, Unit::AmperesRms, {0.1, 100000.0}, 100.0, When::Ready, Slot{}, Output::No, "Reference current", "currents in process data, of which it is 100 %"},
    Row{2003, 1, kAxes, F32, Unit::NewtonMetre, {0.01, 20000000.0}, factory::rated_torque, When::Ready, setting<&ReferenceValues::torque>, Output::No, "Reference torque", "100 % of a torque in process data"},
    Row{2004, 1, kAxes, F32, Unit::Kilowatts, kWhole, 0.0, When::ReadOnly, shown<axis_value::reference_power>, Output::No, "Reference power", "p2003 times p2000"},
    Row{2005, 1, kAxes, F32, Unit::Degrees, {90.0, 180.0}, 90.0, When::Ready, Stored{"a connector that is an angle in degrees"}, Output::No, "Reference angle", ""},
    Row{2006, 1, kAxes, F32, Unit::Celsius, {50.0, 300.0}, 100.0, When::Ready, Slot{}, Output::No, "Reference temperature", "temperatures in process data, of which it is 100 %"},
    Row{2007, 1, kAxes, F32, Unit::RevolutionsPerSecondSquared, {0.01, 500000.0}, 0.01, When::Ready, Slot{}, Output::No, "Reference acceleration", "accelerations in process data, of which it is 100 %"},
};
// clang-format on

}  // namespace drive::rows
