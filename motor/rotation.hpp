#pragma once

#include "motor/space_vector.hpp"

namespace motor {

/// Cosine and sine of a small angle (rad) by their series; 1e-9 up to 0.4, 1e-5 up to 1.
constexpr SpaceVector small_rotation(double angle) noexcept {
  const double s = angle * angle;
  return {1.0 - s * (0.5 - s * (1.0 / 24.0 - s * (1.0 / 720.0))),
          angle * (1.0 - s * (1.0 / 6.0 - s * (1.0 / 120.0 - s * (1.0 / 5040.0))))};
}

/// @p a turned back by an angle whose square does not count (rad).
constexpr SpaceVector turned_back_a_little(SpaceVector a, double angle) noexcept {
  return {a.re + angle * a.im, a.im - angle * a.re};
}

}  // namespace motor
