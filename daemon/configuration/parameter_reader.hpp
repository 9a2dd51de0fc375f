#pragma once

#include <optional>
#include <string>

#include "daemon/configuration/base/json_reader.hpp"
#include "daemon/configuration/configuration.hpp"

namespace axisd {

/// The key "parameters" of control unit, infeed and axes of the file @p json into @p configuration, whose drive
/// objects are read: what each of them takes when it is new. Throws ConfigurationError.
void read_parameters(const JsonReader& json, Configuration& configuration);

/// The first parameter of @p configuration that a new unit would refuse, as one does that is connected to an axis
/// which is not there.
std::optional<std::string> refused_parameter(const Configuration& configuration);

}  // namespace axisd
