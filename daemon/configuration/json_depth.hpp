#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace axisd {

/// Levels of objects and arrays that a file may have; values are copied and printed by recursion.
inline constexpr std::size_t kDeepestFile = 32;

/// Offset of the first bracket in the JSON @p text that opens a level beyond @p deepest, if there is one.
constexpr std::optional<std::size_t> find_too_deep(std::string_view text, std::size_t deepest) noexcept {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (in_string) {
      if (c == '\\') ++at;
      in_string = c != '"';
    } else if (c == '{' || c == '[') {
      if (++depth > deepest) return at;
    } else if (c == '}' || c == ']') {
      if (depth != 0) --depth;
    } else {
      in_string = c == '"';
    }
  }
  return std::nullopt;
}

}  // namespace axisd
