#pragma once

#include <string_view>

#include "text/number.hpp"

namespace bench {

/// Puts the number that @p word is into @p number; false if it is none, or not @p low to @p high.
template <class Number>
bool parse(std::string_view word, Number low, Number high, Number& number, int base = 10) noexcept {
  const auto value = text::integer<Number>(word, base);
  if (!value || *value < low || *value > high) return false;
  number = *value;
  return true;
}

}  // namespace bench
