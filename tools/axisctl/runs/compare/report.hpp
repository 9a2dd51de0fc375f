#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tools/axisctl/runs/compare/difference.hpp"

namespace runs {

/// What came of the comparison of the logs @p a and @p b, for people.
[[nodiscard]] std::string text_of(const Compared& compared, const std::string& a, const std::string& b);
/// The same for programs (docs/reference/runs.md).
[[nodiscard]] nlohmann::json json_of(const Compared& compared, const std::string& a, const std::string& b);

}  // namespace runs
