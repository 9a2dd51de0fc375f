#pragma once

#include <algorithm>

#include "motor/math/rotation.hpp"

namespace motor {

/// @p a turned by the angle of @p b and stretched by its length.
inline SpaceVector product(SpaceVector a, SpaceVector b) noexcept {
  return vector(both(a.re) * pair(b) + both(a.im) * Pair{-b.im, b.re});
}

/// Unit vector at @p angle (rad) by its series; where no machine ever turns in a period, beyond 1.5 rad, it stays.
inline SpaceVector bounded_rotation(double angle) noexcept {
  constexpr double kFurthest = 1.5;
  return vector(small_rotation(std::min(kFurthest, std::max(-kFurthest, angle))));
}

/// @p direction turned by @p angle (rad, small), its length drawn back to 1.
inline SpaceVector turned(SpaceVector direction, double angle) noexcept {
  const SpaceVector next = direction * bounded_rotation(angle);
  return (1.5 - 0.5 * norm(next)) * next;
}

/// Coordinates that turn with a flux: the direction of their d axis in the stator frame, and its speed.
struct Frame {
  SpaceVector direction{1.0, 0.0};
  double frequency = 0.0;  ///< (electrical rad/s)
};

/// What the flux of a machine does at a current: the voltage that its rotation takes, and its torque.
struct FluxEffect {
  SpaceVector voltage{};  ///< (V), in the frame
  double torque = 0.0;    ///< (N·m)
};

}  // namespace motor
