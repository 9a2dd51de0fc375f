#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace drive {

/// Quotient rounded down, of @p divisor > 0.
constexpr std::int64_t floor_divide(std::int64_t value, std::int64_t divisor) noexcept {
  return value / divisor - (value % divisor < 0 ? 1 : 0);
}

/// The range of a position that is shown (LU).
inline constexpr std::int64_t kLowestShown = std::numeric_limits<std::int32_t>::min();
inline constexpr std::int64_t kHighestShown = std::numeric_limits<std::int32_t>::max();

/// Whole length units of an input.
inline std::int64_t whole_units(double value) noexcept {
  return std::llround(std::clamp(value, static_cast<double>(kLowestShown), static_cast<double>(kHighestShown)));
}

}  // namespace drive
