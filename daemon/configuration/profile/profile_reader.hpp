#pragma once

#include <optional>

#include "daemon/configuration/base/json_reader.hpp"
#include "daemon/configuration/settings/cia402_settings.hpp"

namespace axisd {

/// What the object @p unit of a file says of the profile cia402; nothing where its profile is s120. Keys that the
/// profile does not have are none of the unit or of its axes. Throws ConfigurationError.
std::optional<Cia402Settings> read_profile(const JsonReader& unit);

/// The keys of profile cia402 of the object @p axis. Throws ConfigurationError.
Cia402AxisSettings read_cia402_axis(const JsonReader& axis);

/// The switches by their roles, from the array @p json. Throws ConfigurationError.
cia402::TravelSwitches read_role_switches(const JsonReader& json);

}  // namespace axisd
