#include "cia402/quantities/position_scale.hpp"

#include <algorithm>
#include <numeric>

namespace cia402 {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t magnitude(std::int64_t value) noexcept {
  return value < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

/// @p whole with the sign of @p of, at most PositionScale::kFarthest.
constexpr std::int64_t with_sign(Wide whole, std::int64_t of) noexcept {
  constexpr auto kFarthest = static_cast<Wide>(PositionScale::kFarthest);
  const auto bounded = static_cast<std::int64_t>(std::min(whole, kFarthest));
  return of < 0 ? -bounded : bounded;
}

/// @p dividend / @p divisor, a half upwards; @p dividend below 2^127.
constexpr Wide divided(Wide dividend, Wide divisor) noexcept {
  return (dividend + divisor / 2) / divisor;
}

/// Of what has to be multiplied by each other, and divided by the other, common factors go first.
void reduce(std::uint64_t& one, std::uint64_t& other) noexcept {
  const std::uint64_t common = std::gcd(one, other);
  one /= common;
  other /= common;
}

}  // namespace

PositionScale::PositionScale(const PositionMechanics& mechanics) noexcept {
  std::uint64_t units = std::uint64_t{mechanics.shaft_revolutions} * mechanics.feed;
  std::uint64_t gears = std::uint64_t{mechanics.motor_revolutions} * mechanics.feed_revolutions;
  std::uint64_t increments = mechanics.increments;
  units_per_revolution_ = static_cast<double>(units) / static_cast<double>(gears);
  reduce(units, gears);
  reduce(units, increments);
  units_ = units;
  increments_ = Wide{gears} * increments;
}

std::int64_t PositionScale::units(std::int64_t increments) const noexcept {
  return with_sign(divided(Wide{magnitude(increments)} * units_, increments_), increments);
}

double PositionScale::exact_units(std::int64_t increments) const noexcept {
  const Wide product = Wide{magnitude(increments)} * units_;
  const Wide whole = product / increments_;
  const auto rest = static_cast<double>(product - whole * increments_) / static_cast<double>(increments_);
  const double units = static_cast<double>(whole) + rest;
  const double bounded = std::min(units, static_cast<double>(kFarthest));
  return increments < 0 ? -bounded : bounded;
}

/// The whole part of the ratio first: what is left multiplies without an overflow.
std::int64_t PositionScale::increments(std::int64_t units) const noexcept {
  const Wide whole = increments_ / units_;
  const Wide rest = increments_ % units_;
  const Wide size = magnitude(units);
  if (whole > static_cast<Wide>(kFarthest)) return with_sign(size == 0 ? 0 : whole, units);
  return with_sign(size * whole + divided(size * rest, units_), units);
}

}  // namespace cia402
