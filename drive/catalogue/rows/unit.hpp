#pragma once

#include <array>

#include "drive/parameter/row.hpp"
#include "drive/sequence_control/sequence_control.hpp"
#include "drive/values/axis_values.hpp"
#include "drive/values/checks.hpp"
#include "drive/values/factory_values.hpp"
#include "drive/values/unit_values.hpp"

namespace drive::rows {

/// The unit, commissioning, saving, terminals.
// clang-format off
inline constexpr std::array kUnitRows{
    Row{9, 1, kControlUnit, I16, Unit::None, {0.0, 10100.0}, 0.0, When::Ready, Agreed{}, Output::No, "Device commissioning parameter filter", "not 0: switching on is inhibited on every axis; leaving 3 restarts the unit", Keep::No, check::device_filter},
    Row{18, 1, kControlUnit, U32, Unit::None, kWhole, double{kFirmware}, When::ReadOnly, Agreed{}, Output::No, "CU firmware version", "100Ah"},
    Row{50, 1, kAxes, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "command data sets, of which there is one"}, Output::Both, "Command data set effective", ""},
    Row{51, 1, kAxes, U8, Unit::None, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "drive data sets, of which there is one"}, Output::Both, "Drive data set effective", ""},
    Row{97, 1, kControlUnit, I16, Unit::None, {0.0, 17.0}, 0.0, When::Ready, Stored{until::kDriveObjects}, Output::No, "Select drive object type", ""},
    Row{100, 1, kAxes, I16, Unit::None, {0.0, 1.0}, 0.0, When::Quick, Stored{"motor data in NEMA units"}, Output::No, "IEC/NEMA motor standard", ""},
    Row{101, 24, kControlUnit, U16, Unit::None, {0.0, 62.0}, factory::object_number, When::Device, Stored{until::kDriveObjects}, Output::No, "Drive object numbers", ""},
    Row{102, 2, kControlUnit, U16, Unit::None, kWhole, 0.0, When::ReadOnly, shown<unit_value::object_count>, Output::No, "Number of drive objects", "without and with inactive ones"},
    Row{107, 24, kControlUnit, I16, Unit::None, kWhole, factory::object_type, When::Device, Stored{until::kDriveObjects}, Output::No, "Drive object type", ""},
    Row{108, 24, kControlUnit, U32, Unit::None, kWhole, factory::object_modules, When::Device, Slot{}, Output::No, "Drive object function modules", "r0108 when p0009 becomes 0: bit 8 of a servo, the extended setpoint channel; bit 29 (CAN) stays; bits 3 and 4 show what the configuration has; other modules do not exist", Keep::Stored, check::function_modules},
    Row{108, 1, kAxes, U32, Unit::None, kWhole, 0.0, When::ReadOnly, shown<axis_value::function_modules>, Output::No, "Drive object function modules", "bits 3 position control, 4 basic positioner, 8 extended setpoint channel, 29 CAN"},
    Row{115, 12, kServo, F32, Unit::Microseconds, {0.0, 16000.0}, factory::sampling_times, When::Device, Slot{}, Output::No, "Sampling times of the control loops", "the number of PDOs that may be valid (r8742); the control loops run every 125 µs"},
    Row{115, 12, kVector, F32, Unit::Microseconds, {0.0, 16000.0}, factory::vector_sampling_times, When::Device, Slot{}, Output::No, "Sampling times of the control loops", "the number of PDOs that may be valid (r8742); the control loops run every 125 µs"},
    Row{205, 1, kAxes, I16, Unit::None, {0.0, 7.0}, 0.0, When::Quick, Stored{"power units with several load duty cycles"}, Output::No, "Power unit application", ""},
    Row{210, 1, kAxes | kInfeed, F32, Unit::VoltsRms, {70.0, 1000.0}, 400.0, When::Ready, Stored{"a supply that follows it; the configuration gives the line voltage"}, Output::No, "Device supply voltage", ""},
    Row{500, 1, kServo, I16, Unit::None, {100.0, 102.0}, 100.0, When::QuickReady, Stored{"presets of a technology application"}, Output::No, "Technology application", ""},
    Row{500, 1, kVector, I16, Unit::None, {0.0, 6.0}, 0.0, When::QuickReady, Stored{"presets of a technology application"}, Output::No, "Technology application", ""},
    Row{774, 3, kControlUnit, F32, Unit::Volts, kWhole, 0.0, When::ReadOnly, Fixed{0.0, "test sockets of the control unit"}, Output::Connector, "Test sockets output voltage T0..T2", ""},
    Row{918, 1, kControlUnit, U16, Unit::None, {1.0, 126.0}, 126.0, When::Ready, Stored{"PROFIBUS"}, Output::No, "PROFIBUS address", ""},
    Row{969, 1, kControlUnit, U32, Unit::Milliseconds, {0.0, 4294967295.0}, 0.0, When::Always, HostCommand{}, Output::No, "System runtime relative", "", Keep::No},
    Row{970, 1, kAxes, U16, Unit::None, {0.0, 100.0}, 0.0, When::Reset, shown<axis_value::no_value, axis_value::reset_parameters>, Output::No, "Reset drive object parameters", "1 resets this drive object and p0010; reads 0", Keep::No},
    Row{971, 1, kAll, U16, Unit::None, {0.0, 1.0}, 0.0, When::Always, HostCommand{}, Output::No, "Save drive object parameters", "1 saves this drive object; reads 0", Keep::No},
    Row{972, 1, kControlUnit, U16, Unit::None, {0.0, 3.0}, 0.0, When::Always, HostCommand{}, Output::No, "Drive unit reset", "1 restarts the unit, 2 is only shown, 3 restarts it when the node leaves Operational", Keep::No},
    Row{976, 1, kControlUnit, U16, Unit::None, {0.0, 1013.0}, 0.0, When::DeviceReset, HostCommand{}, Output::No, "Reset and load all parameters", "1 state of a new unit, 2 restart with the saved values; reads 0", Keep::No},
    Row{977, 1, kControlUnit, U16, Unit::None, {0.0, 1013.0}, 0.0, When::Always, HostCommand{}, Output::No, "Save all parameters", "1 saves all drive objects; reads 0", Keep::No},
    Row{978, 25, kControlUnit, U8, Unit::None, {0.0, 255.0}, factory::cyclic_object, When::Device, Slot{}, Output::No, "List of drive objects with cyclic exchange", "the axis of Modbus TCP at index 0; behind the first 0 none takes part, 255 is visible but empty"},
};
// clang-format on

}  // namespace drive::rows
