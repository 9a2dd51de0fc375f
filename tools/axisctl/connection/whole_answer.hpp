#pragma once

#include <functional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "tools/axisctl/connection/failure.hpp"

namespace axisctl {

/// Asks a unit for a method with parameters.
using Ask = std::function<Expected<nlohmann::json>(std::string_view method, nlohmann::json params)>;

/// The result of @p method; the pages of a long one together, unless @p params ask for a part.
[[nodiscard]] Expected<nlohmann::json> ask_whole(const Ask& ask, std::string_view method, nlohmann::json params);

}  // namespace axisctl
