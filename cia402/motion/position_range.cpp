#include "cia402/motion/position_range.hpp"

#include <cmath>

namespace cia402 {

/// 6064h is the position rounded half away from zero, so half a unit below the range still is in it.
double turns_before(double position, const Span& range) noexcept {
  const double turn = modulus(range);
  return turn * std::floor((std::round(position) - range.low) / turn);
}

std::optional<Span> software_limits_at(double position, const Limits& limits) noexcept {
  if (!limits.software || !limits.range) return limits.software;
  const Span& software = *limits.software;
  if (software.low <= limits.range->low && software.high >= limits.range->high) return std::nullopt;
  const double turns = turns_before(position, *limits.range);
  return Span{software.low + turns, software.high + turns};
}

}  // namespace cia402
