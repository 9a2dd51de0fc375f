#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace motor {

/// A three-phase quantity as a vector, peak valued: the length is the amplitude of a phase. Stator frame: re =
/// alpha (phase a), im = beta; rotor frame: re = d, im = q.
struct SpaceVector {
  double re = 0.0;
  double im = 0.0;

  constexpr friend SpaceVector operator+(SpaceVector a, SpaceVector b) noexcept {
    return {a.re + b.re, a.im + b.im};
  }
  constexpr friend SpaceVector operator-(SpaceVector a, SpaceVector b) noexcept {
    return {a.re - b.re, a.im - b.im};
  }
  constexpr friend SpaceVector operator*(double k, SpaceVector a) noexcept { return {k * a.re, k * a.im}; }
  /// Turned by the angle of @p b and stretched by its length.
  constexpr friend SpaceVector operator*(SpaceVector a, SpaceVector b) noexcept {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend bool operator==(const SpaceVector&, const SpaceVector&) = default;
};

/// The vector turned back by what @p a turns forth.
constexpr SpaceVector conjugate(SpaceVector a) noexcept {
  return {a.re, -a.im};
}
/// Real part of a·conj(b): 1.5 of it is the power of voltage and current.
constexpr double dot(SpaceVector a, SpaceVector b) noexcept {
  return a.re * b.re + a.im * b.im;
}
/// Imaginary part of conj(a)·b: 1.5 pole pairs of it is the torque of flux and current.
constexpr double cross(SpaceVector a, SpaceVector b) noexcept {
  return a.re * b.im - a.im * b.re;
}
/// Square of the length.
constexpr double norm(SpaceVector a) noexcept {
  return dot(a, a);
}
/// Length.
inline double length(SpaceVector a) noexcept {
  return std::sqrt(norm(a));
}

/// Its values in the phases U, V, W.
constexpr std::array<double, 3> phase_values(SpaceVector a) noexcept {
  constexpr double kHalfSqrt3 = 0.5 * std::numbers::sqrt3;
  return {a.re, -0.5 * a.re + kHalfSqrt3 * a.im, -0.5 * a.re - kHalfSqrt3 * a.im};
}
/// The vector of the values @p phases in U, V, W; what they have in common is no part of it.
constexpr SpaceVector vector_of(const std::array<double, 3>& phases) noexcept {
  constexpr double kThirdSqrt3 = std::numbers::inv_sqrt3;
  return {(2.0 * phases[0] - phases[1] - phases[2]) / 3.0, (phases[1] - phases[2]) * kThirdSqrt3};
}

}  // namespace motor
