#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "cia402/base/limits.hpp"

namespace cia402 {

/// The range 607Bh, @p minimum to @p maximum, if it is in force: not at both ends of its type, and not empty.
constexpr std::optional<Span> range_in_force(std::int32_t minimum, std::int32_t maximum) noexcept {
  using Ends = std::numeric_limits<std::int32_t>;
  const bool is_all = minimum == Ends::min() && maximum == Ends::max();
  if (is_all || minimum >= maximum) return std::nullopt;
  return Span{static_cast<double>(minimum), static_cast<double>(maximum)};
}

/// Position units until the same place comes again: 0 to 359 are 360 units.
constexpr double modulus_of(const Span& range) noexcept {
  return range.high - range.low + 1.0;
}

/// Whole turns that lie between @p position and its place in @p range, negative below it.
inline double turns_of(double position, const Span& range) noexcept {
  return std::floor((position - range.low) / modulus_of(range));
}

/// @p position as 6064h and 6062h show it: whole units, from range.low to range.high.
constexpr std::int64_t wrapped(std::int64_t position, const Span& range) noexcept {
  const auto low = static_cast<std::int64_t>(range.low);
  const auto modulus = static_cast<std::int64_t>(modulus_of(range));
  // Each part first: the difference of the ends of 64 bits would not fit.
  const std::int64_t rest = (position % modulus - low % modulus) % modulus;
  return low + (rest < 0 ? rest + modulus : rest);
}

/// The place of @p target that is nearest to @p from; of two that are as far the one in positive direction.
inline double nearest(double target, double from, const Span& range) noexcept {
  const double modulus = modulus_of(range);
  return target + std::floor((from - target) / modulus + 0.5) * modulus;
}

}  // namespace cia402
