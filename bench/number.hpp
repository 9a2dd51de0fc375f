#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace bench {

/// Puts the number that @p word is into @p number; false if it is none, or not @p low to @p high.
template <class Number>
bool parse(std::string_view word, Number low, Number high, Number& number, int base = 10) noexcept {
  const char* const end = word.data() + word.size();
  Number value{};
  const auto [rest, error] = std::from_chars(word.data(), end, value, base);
  if (error != std::errc{} || rest != end || value < low || value > high) return false;
  number = value;
  return true;
}

}  // namespace bench
