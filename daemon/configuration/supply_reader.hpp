#pragma once

#include "daemon/configuration/base/json_reader.hpp"
#include "motor/data/inverter_data.hpp"
#include "motor/data/supply_data.hpp"

namespace axisd {

/// The DC link of the unit, from the object @p json. Throws ConfigurationError where none can be as it says.
motor::SupplyData read_supply(const JsonReader& json);

/// Changes those properties of @p inverter that the object @p json has.
motor::InverterData read_power_unit(const JsonReader& json, motor::InverterData inverter);

}  // namespace axisd
