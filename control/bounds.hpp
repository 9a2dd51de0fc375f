#pragma once

#include <string>

#include "control/method.hpp"

namespace control {

/// What @p parameter may be, for a message: "0 to 17, 20 or 21" of terminals, "a, b or c" of choices; each choice
/// between two @p quote.
[[nodiscard]] std::string alternatives_of(const Parameter& parameter, std::string_view quote = "");
/// @p value without a fraction.
[[nodiscard]] std::string whole(double value);

}  // namespace control
