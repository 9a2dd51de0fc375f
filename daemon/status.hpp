#pragma once

#include <nlohmann/json.hpp>

namespace axisd {

class Daemon;

/// The state of the unit as the control method `status` shows it.
nlohmann::json status_of(const Daemon& daemon);

}  // namespace axisd
