#include "drive/positioning/actual_position/length_scale.hpp"

#include <algorithm>
#include <numeric>

namespace drive {
namespace {

/// Holds the product of any count and any ratio of parameters.
__extension__ using Wide = __int128;

constexpr Wide kFarthest = Wide{1} << 61;  // LU

}  // namespace

LengthScale::LengthScale(const LengthMechanics& mechanics) noexcept
    : units_{std::int64_t{mechanics.units_per_load} * mechanics.gear_load},
      per_revolution_{static_cast<std::int64_t>(mechanics.pulses) << mechanics.fine_bits},
      units_per_revolution_{static_cast<double>(units_) / mechanics.gear_motor} {
  counts_ = per_revolution_ * mechanics.gear_motor;
  const std::int64_t common = std::gcd(units_, counts_);
  units_ /= common;
  counts_ /= common;
}

Length LengthScale::length(std::int64_t counts) const noexcept {
  const Wide product = Wide{counts} * units_;
  const Wide half = counts_ / 2;  // of an odd divisor the remainder decides: no half lies between
  const Wide whole = (product < 0 ? product - half : product + half) / counts_;
  if (whole > kFarthest || whole < -kFarthest)
    return {.whole = static_cast<std::int64_t>(std::clamp(whole, -kFarthest, kFarthest)), .rest = 0.0};
  const auto rest = static_cast<std::int64_t>(product - whole * counts_);
  return {.whole = static_cast<std::int64_t>(whole),
          .rest = static_cast<double>(rest) / static_cast<double>(counts_)};
}

bool LengthScale::is_multiple(std::int64_t revolutions, std::int64_t length) const noexcept {
  const Wide units = Wide{revolutions} * per_revolution_ * units_;
  return units % (Wide{counts_} * length) == 0;
}

}  // namespace drive
