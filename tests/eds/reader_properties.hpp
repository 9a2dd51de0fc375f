#pragma once

#include <string>
#include <string_view>

namespace eds {

/// What does not hold although it must whatever @p text is: that it is read and written back byte by byte, that
/// every finding is one printable line, that a file has no difference from itself, and that whatever is made from
/// it can be read again. Empty where everything holds.
[[nodiscard]] std::string broken_property(std::string_view text);

}  // namespace eds
