#pragma once

#include <map>
#include <string>

#include "daemon/configuration/base/json_reader.hpp"
#include "drive/base/load_mechanics.hpp"

namespace axisd {

/// Gear and pitch from the object @p load. Throws ConfigurationError where nothing can be as it says.
drive::LoadMechanics read_mechanics(const JsonReader& load);

/// Inputs of the unit that switches feed, and where in the file these stand.
using FedInputs = std::map<int, std::string>;

/// The switches beside the way of a load, from the array @p json; their inputs are none of @p fed, and are added.
/// Throws ConfigurationError.
drive::TravelSwitchList read_switches(const JsonReader& json, FedInputs& fed);

}  // namespace axisd
