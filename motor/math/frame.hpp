#pragma once

#include "motor/math/rotation.hpp"

namespace motor {

/// @p a turned by the angle of @p b and stretched by its length.
template <class Number>
[[gnu::always_inline]] inline SpaceVectorOf<Number> product(const SpaceVectorOf<Number>& a,
                                                            const SpaceVectorOf<Number>& b) noexcept {
  return vector(both(a.re) * pair(b) + both(a.im) * PairOf<Number>{-b.im, b.re});
}

/// Unit vector at @p angle (rad) by its series; where no machine ever turns in a period, beyond 1.5 rad, it stays.
template <class Number>
[[gnu::always_inline]] inline SpaceVectorOf<Number> bounded_rotation(const Number& angle) noexcept {
  constexpr double kFurthest = 1.5;
  return vector(small_rotation(minimum<Number>(kFurthest, maximum<Number>(-kFurthest, angle))));
}

/// @p direction turned by @p angle (rad, small), its length drawn back to 1.
template <class Number>
[[gnu::always_inline]] inline SpaceVectorOf<Number> turned(const SpaceVectorOf<Number>& direction,
                                                           const Number& angle) noexcept {
  const SpaceVectorOf<Number> next = direction * bounded_rotation(angle);
  return (1.5 - 0.5 * norm(next)) * next;
}

/// Coordinates that turn with a flux: the direction of their d axis in the stator frame, and its speed.
template <class Number>
struct FrameOf {
  SpaceVectorOf<Number> direction{1.0, 0.0};
  Number frequency = 0.0;  ///< (electrical rad/s)
};
using Frame = FrameOf<double>;

/// What the flux of a machine does at a current: the voltage that its rotation takes, and its torque.
template <class Number>
struct FluxEffectOf {
  SpaceVectorOf<Number> voltage{};  ///< (V), in the frame
  Number torque = 0.0;              ///< (N·m)
};
using FluxEffect = FluxEffectOf<double>;

}  // namespace motor
