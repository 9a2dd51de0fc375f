#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "daemon/configuration.hpp"
#include "daemon/json_reader.hpp"

namespace axisd {

/// The values under the parameters that the object @p json has as keys, as the new axis at @p place (from 0) of @p
/// axes takes them. Throws ConfigurationError.
std::vector<ParameterValue> read_axis_parameters(const JsonReader& json,
                                                 const std::vector<AxisConfiguration>& axes, std::size_t place);

/// The same for a new control unit with @p axes: parameters that it saves.
std::vector<ParameterValue> read_unit_parameters(const JsonReader& json,
                                                 const std::vector<AxisConfiguration>& axes);

/// The first parameter of @p configuration that a new unit would refuse, as one does that is connected to an axis
/// which is not there.
std::optional<std::string> refused_parameter(const Configuration& configuration);

}  // namespace axisd
