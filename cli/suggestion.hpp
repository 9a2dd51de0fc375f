#pragma once

#include <span>
#include <string>
#include <string_view>

namespace cli {

/// The one of @p names that @p word is most likely meant to be, empty if none is near: what differs by two letters
/// added, left out, changed or exchanged with a neighbour, and by less than half of the word.
[[nodiscard]] std::string nearest(std::string_view word, std::span<const std::string> names);

}  // namespace cli
