#pragma once

#include <string>
#include <string_view>

namespace cli {

/// @p text for a man page in the language of scdoc, where nothing in it means anything but itself.
[[nodiscard]] std::string scdoc_text(std::string_view text);

}  // namespace cli
