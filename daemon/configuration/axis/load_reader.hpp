#pragma once

#include "daemon/configuration/base/json_reader.hpp"
#include "drive/base/load_mechanics.hpp"
#include "motor/data/load.hpp"
#include "motor/data/machine_data.hpp"

namespace axisd {

/// What hangs on the shaft of @p machine, from the object @p json, behind @p mechanics, from which it is referred
/// to the shaft. Throws ConfigurationError where nothing can be as it says.
motor::Load read_load(const JsonReader& json, const motor::MachineData& machine,
                      const drive::LoadMechanics& mechanics);

}  // namespace axisd
