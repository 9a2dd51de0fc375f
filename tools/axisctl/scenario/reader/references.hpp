#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace scenario {

/// What is wrong with the names in a scenario whose keys and values are right: units, programs, steps, faults and
/// methods that are not there, or are there twice. One line that begins with the path; nothing if all is right.
[[nodiscard]] std::optional<std::string> find_wrong_name(const nlohmann::json& scenario);

}  // namespace scenario
