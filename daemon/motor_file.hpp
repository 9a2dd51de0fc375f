#pragma once

#include <set>
#include <span>
#include <string>

#include "daemon/quantity_keys.hpp"
#include "motor/data/machine_data.hpp"

namespace axisd {

/// The numbers that a motor file can have, in the order of the machine's data sheet.
std::span<const QuantityKey<motor::MachineData>> motor_keys();

/// The motor that a configuration names: a preset, or the path of a motor file (with / or .) from the folder of
/// the configuration. Throws ConfigurationError if there is none or no machine can be as it says.
motor::MachineData read_motor(const JsonReader& json);

/// Changes those properties of @p encoder that the object @p json has.
void read_encoder(const JsonReader& json, motor::EncoderData& encoder);

/// Names of the presets that are found: those of the user ($XDG_CONFIG_HOME/axisd/motors) and those that
/// were installed or built with the program (share/axisd/motors in a folder above it).
std::set<std::string> motor_presets();

}  // namespace axisd
