#pragma once

#include <cstdint>

#include "cia402/quantities/rounding.hpp"

namespace cia402 {

/// Torques in per thousand of the rated torque 6076h (mN·m), and currents in those of the rated current 6075h
/// (mA).
class RatedScale {
 public:
  /// @p rated: 6076h or 6075h; 0 makes everything 0.
  explicit constexpr RatedScale(std::uint32_t rated) noexcept : rated_{static_cast<double>(rated)} {}

  /// N·m or A of @p permille.
  constexpr double physical(double permille) const noexcept { return permille * rated_ / kParts; }
  /// Per thousand of @p physical (N·m or A), with their fraction.
  constexpr double permille(double physical) const noexcept {
    return rated_ > 0.0 ? physical * kParts / rated_ : 0.0;
  }
  /// The same as an object shows them (6074h, 6077h, 6078h).
  std::int16_t shown(double physical) const noexcept { return rounded<std::int16_t>(permille(physical)); }

 private:
  static constexpr double kParts = 1e6;  // a thousandth of what is told in thousandths

  double rated_;
};

}  // namespace cia402
