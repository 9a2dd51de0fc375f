#pragma once

#include "daemon/configuration/base/json_reader.hpp"
#include "trace/settings.hpp"

namespace axisd {

/// A trace as the object @p json says; whether its signals exist only the unit knows. Throws ConfigurationError.
trace::Settings read_trace(const JsonReader& json);

}  // namespace axisd
