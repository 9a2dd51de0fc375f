#pragma once

#include <span>
#include <string>

#include "daemon/configuration/base/quantity_keys.hpp"
#include "daemon/configuration/settings/motor_source.hpp"
#include "motor/data/machine_data.hpp"

namespace axisd {

/// The numbers that a motor file can have, in the order of the machine's data sheet.
std::span<const QuantityKey<motor::MachineData>> motor_keys();

/// The motor that a configuration names: a preset, or the path of a motor file (with / or .) from the folder of
/// the configuration; @p motors has them. Throws ConfigurationError if there is none or no machine can be as it
/// says.
motor::MachineData read_motor(const JsonReader& json, const MotorSource& motors);

/// Changes those properties of @p encoder that the object @p json has.
void read_encoder(const JsonReader& json, motor::EncoderData& encoder);

}  // namespace axisd
