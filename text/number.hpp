#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace text {

/// Takes the integer at the start of @p rest off it, digits of @p base without a prefix; nothing, and @p rest as
/// it was, if there is none or Integer cannot hold it.
template <class Integer>
std::optional<Integer> take_integer(std::string_view& rest, int base = 10) noexcept {
  Integer value = 0;
  const char* const begin = rest.data();
  const auto [stop, error] = std::from_chars(begin, begin + rest.size(), value, base);
  if (error != std::errc{}) return std::nullopt;
  rest.remove_prefix(static_cast<std::size_t>(stop - begin));
  return value;
}

/// The integer that all of @p digits spell in @p base; nothing if they spell none or Integer cannot hold it.
template <class Integer>
std::optional<Integer> integer(std::string_view digits, int base = 10) noexcept {
  const auto value = take_integer<Integer>(digits, base);
  return digits.empty() ? value : std::nullopt;
}

/// The number that all of @p digits spell in @p format; nothing if they spell none or a double cannot hold it.
inline std::optional<double> real(std::string_view digits,
                                  std::chars_format format = std::chars_format::general) noexcept {
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, format);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace text
