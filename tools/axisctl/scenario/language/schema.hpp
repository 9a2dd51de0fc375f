#pragma once

#include <nlohmann/json.hpp>

namespace scenario {

/// The schema of scenarios (JSON Schema 2020-12), made of the tables of keys.
[[nodiscard]] nlohmann::ordered_json schema();

}  // namespace scenario
