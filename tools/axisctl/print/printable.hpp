#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisctl {

/// @p text with every control character (C0, DEL, and C1 in UTF-8) as \u00XX: what comes from elsewhere shall not
/// move the cursor of a terminal.
[[nodiscard]] std::string printable(std::string_view text);

/// @p value with printable() texts and keys.
[[nodiscard]] nlohmann::json printable_values(const nlohmann::json& value);

}  // namespace axisctl
