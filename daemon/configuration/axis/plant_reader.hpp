#pragma once

#include "daemon/configuration/base/json_reader.hpp"
#include "motor/data/load.hpp"
#include "motor/data/plant_deviation.hpp"

namespace axisd {

/// The factors by which what turns differs from the data sheet @p machine, from the object @p json. Throws
/// ConfigurationError where no machine of that type with @p load can be so.
motor::PlantDeviation read_plant(const JsonReader& json, const motor::MachineData& machine,
                                 const motor::Load& load);

}  // namespace axisd
