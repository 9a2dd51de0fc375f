#pragma once

#include <cmath>

namespace drive {

/// Undoes the rounding that the way through SI units leaves in the last digits of @p value.
inline double rounded(double value) noexcept {
  constexpr double kDigits = 1e9;
  return std::abs(value) < 1e6 ? std::round(value * kDigits) / kDigits : value;
}

}  // namespace drive
