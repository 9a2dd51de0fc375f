#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cia402 {

/// @p value in an object of 8, 16 or 32 bits; beyond its range its end is shown.
template <class Integer>
constexpr Integer saturated(std::int64_t value) noexcept {
  static_assert(sizeof(Integer) < sizeof value);
  return static_cast<Integer>(
      std::clamp<std::int64_t>(value, std::numeric_limits<Integer>::min(), std::numeric_limits<Integer>::max()));
}

/// The same of a number with a fraction: a half is rounded away from zero, and what is no number is 0.
template <class Integer>
Integer rounded(double value) noexcept {
  constexpr double kLowest = std::numeric_limits<Integer>::min();
  constexpr double kHighest = std::numeric_limits<Integer>::max();
  return std::isnan(value) ? Integer{0} : static_cast<Integer>(std::clamp(std::round(value), kLowest, kHighest));
}

}  // namespace cia402
