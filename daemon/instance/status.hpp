#pragma once

#include <nlohmann/json.hpp>

namespace axisd {

class Instance;

/// The state of the unit as the control method `status` shows it.
nlohmann::json status_of(const Instance& instance);

}  // namespace axisd
