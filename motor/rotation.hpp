#pragma once

#include "motor/space_vector.hpp"

namespace motor {

/// Unit vector at @p angle (rad) by its power series: exact to 2e-7 up to 0.7 rad, which no machine turns within
/// one and a half control periods; finite for every finite angle.
constexpr SpaceVector small_rotation(double angle) noexcept {
  const double square = angle * angle;
  const double cosine = 1.0 - square * (1.0 / 2 - square * (1.0 / 24 - square * (1.0 / 720)));
  const double sine = 1.0 - square * (1.0 / 6 - square * (1.0 / 120 - square * (1.0 / 5040)));
  return {cosine, angle * sine};
}

/// @p direction turned by @p angle (rad, small), its length drawn back to 1.
constexpr SpaceVector turned(SpaceVector direction, double angle) noexcept {
  const SpaceVector next = direction * small_rotation(angle);
  return (1.5 - 0.5 * norm(next)) * next;
}

/// Coordinates that turn with a flux: the direction of their d axis in the stator frame, and its speed.
struct Frame {
  SpaceVector direction{1.0, 0.0};
  double frequency = 0.0;  ///< (electrical rad/s)
};

}  // namespace motor
