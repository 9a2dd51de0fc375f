#pragma once

#include <vector>

#include "daemon/configuration/base/json_reader.hpp"
#include "injection/language/fault.hpp"

namespace axisd {

/// The faults of a unit on the wire that @p json, a list, says. Throws ConfigurationError.
std::vector<injection::Fault> read_faults(const JsonReader& json);

}  // namespace axisd
