#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/axisctl/scenario/language/keys.hpp"

namespace scenario {

/// What is wrong with the scenario @p value, in one line that begins with the path of the key; nothing if it is
/// written as it has to be. Names are not looked up.
[[nodiscard]] std::optional<std::string> find_mistake(const nlohmann::json& value);

/// The row of @p rows whose key @p object has; null without one.
[[nodiscard]] const Alternative* alternative_of(const nlohmann::json& object, std::span<const Alternative> rows);

}  // namespace scenario
