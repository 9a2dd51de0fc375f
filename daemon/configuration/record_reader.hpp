#pragma once

#include "daemon/configuration/base/json_reader.hpp"
#include "daemon/configuration/settings/record_settings.hpp"

namespace axisd {

/// A recording as the object @p json says; whether its signals exist only the unit knows. Throws
/// ConfigurationError.
RecordSettings read_record(const JsonReader& json);

}  // namespace axisd
