#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace text {

/// Letters of the longest name that a bus, a farm or a host can have.
inline constexpr std::size_t kLongestName = 32;
/// What such a name is, for messages.
inline constexpr const char* kNameForm = "1 to 32 letters, digits, '-' and '_'";

/// Whether a name may have @p c.
constexpr bool is_of_name(char c) noexcept {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  return kLetters.find(c) != std::string_view::npos;
}

/// Whether @p text is one.
constexpr bool is_name(std::string_view text) noexcept {
  return !text.empty() && text.size() <= kLongestName && std::ranges::all_of(text, is_of_name);
}

}  // namespace text
