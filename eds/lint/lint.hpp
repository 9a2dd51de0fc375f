#pragma once

#include <string>
#include <string_view>

#include "eds/document/finding.hpp"

namespace eds {

/// Everything that is wrong with the EDS or DCF @p text, by line. @p file is the name that the findings bear, a
/// path or not; its last part is compared with what FileInfo says.
[[nodiscard]] Findings lint(std::string_view text, const std::string& file);

}  // namespace eds
