#pragma once

#include <optional>

#include "cia402/base/limits.hpp"

namespace cia402 {

/// How far the coordinates go on until they are the same again (607Bh; position units).
constexpr double modulus(const Span& range) noexcept {
  return range.high - range.low + 1.0;
}

/// What @p position, before 607Bh wraps it, is more than the coordinate that is shown: whole turns (position
/// units).
double turns_before(double position, const Span& range) noexcept;

/// The software limits (607Dh) of the turn that @p position, before 607Bh wraps it, lies in, as such positions;
/// none if they are not in force or leave the whole range free.
std::optional<Span> software_limits_at(double position, const Limits& limits) noexcept;

}  // namespace cia402
