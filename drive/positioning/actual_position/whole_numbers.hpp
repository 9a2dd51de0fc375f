#pragma once

#include <cstdint>

namespace drive {

/// Quotient rounded down, of @p divisor > 0.
constexpr std::int64_t floor_divide(std::int64_t value, std::int64_t divisor) noexcept {
  return value / divisor - (value % divisor < 0 ? 1 : 0);
}

}  // namespace drive
