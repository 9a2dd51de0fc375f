#pragma once

#include <optional>

#include "daemon/configuration/base/json_reader.hpp"
#include "daemon/configuration/settings/cia402_settings.hpp"
#include "daemon/configuration/settings/profile.hpp"

namespace axisd {

/// What the object @p unit of a file says of the profile cia402; nothing where its profile is s120. @p profile is
/// in place of what the file says. Keys of the other profile are refused. Throws ConfigurationError.
std::optional<Cia402Settings> read_profile(const JsonReader& unit, std::optional<Profile> profile);

/// The node-ID of a device of profile cia402, from the value @p json. Throws ConfigurationError.
int read_cia402_node_id(const JsonReader& json);

/// The keys of profile cia402 of the object @p axis. Throws ConfigurationError.
Cia402AxisSettings read_cia402_axis(const JsonReader& axis);

/// The switches by their roles, from the array @p json. Throws ConfigurationError.
cia402::TravelSwitches read_role_switches(const JsonReader& json);

}  // namespace axisd
