#pragma once

#include <nlohmann/json.hpp>

namespace axisd {

class Instance;

/// What has been counted of @p instance since its power-on, as the control method `metrics` gives it.
nlohmann::json metrics_of(const Instance& instance);

}  // namespace axisd
