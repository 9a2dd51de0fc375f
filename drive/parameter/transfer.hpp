#pragma once

#include <algorithm>
#include <cmath>

#include "drive/parameter/value.hpp"

namespace drive {

/// @p number as @p type holds it: rounded to an integer, at the ends of the type saturated.
inline ParameterValue transferred(DataType type, double number) noexcept {
  const DataTypeRow& row = row_of(type);
  const double bounded = std::clamp(number, row.lowest, row.highest);
  return encode(type, type == DataType::F32 ? bounded : std::round(bounded));
}

/// Whether @p one and @p other are the same within what conversions of units leave of a floating-point number.
inline bool is_same(const ParameterValue& one, const ParameterValue& other) noexcept {
  constexpr double kRelative = 1e-6;
  constexpr double kAbsolute = 2e-9;
  if (one.type != DataType::F32 || other.type != DataType::F32) return one == other;
  const double a = decode(one), b = decode(other);
  return !(std::abs(a - b) > std::max(kAbsolute, kRelative * std::abs(a)));
}

}  // namespace drive
