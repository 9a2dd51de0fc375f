#pragma once

#include <array>
#include <numbers>

#include "motor/math/number.hpp"

namespace motor {

/// A three-phase quantity as a vector, peak valued: the length is the amplitude of a phase. Stator frame: re =
/// alpha (phase a), im = beta; rotor frame: re = d, im = q.
template <class Number>
struct SpaceVectorOf {
  Number re = 0.0;
  Number im = 0.0;

  constexpr friend SpaceVectorOf operator+(const SpaceVectorOf& a, const SpaceVectorOf& b) noexcept {
    return {a.re + b.re, a.im + b.im};
  }
  constexpr friend SpaceVectorOf operator-(const SpaceVectorOf& a, const SpaceVectorOf& b) noexcept {
    return {a.re - b.re, a.im - b.im};
  }
  constexpr friend SpaceVectorOf operator*(const Number& k, const SpaceVectorOf& a) noexcept {
    return {k * a.re, k * a.im};
  }
  /// Turned by the angle of @p b and stretched by its length.
  constexpr friend SpaceVectorOf operator*(const SpaceVectorOf& a, const SpaceVectorOf& b) noexcept {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend bool operator==(const SpaceVectorOf&, const SpaceVectorOf&) = default;
};
using SpaceVector = SpaceVectorOf<double>;

/// The vector turned back by what @p a turns forth.
template <class Number>
constexpr SpaceVectorOf<Number> conjugate(const SpaceVectorOf<Number>& a) noexcept {
  return {a.re, -a.im};
}
/// Real part of a·conj(b): 1.5 of it is the power of voltage and current.
template <class Number>
constexpr Number dot(const SpaceVectorOf<Number>& a, const SpaceVectorOf<Number>& b) noexcept {
  return a.re * b.re + a.im * b.im;
}
/// Imaginary part of conj(a)·b: 1.5 pole pairs of it is the torque of flux and current.
template <class Number>
constexpr Number cross(const SpaceVectorOf<Number>& a, const SpaceVectorOf<Number>& b) noexcept {
  return a.re * b.im - a.im * b.re;
}
/// Square of the length.
template <class Number>
constexpr Number norm(const SpaceVectorOf<Number>& a) noexcept {
  return dot(a, a);
}
/// Length.
template <class Number>
Number length(const SpaceVectorOf<Number>& a) noexcept {
  return sqrt(norm(a));
}
/// @p a where @p condition holds, @p b elsewhere.
template <class Number>
SpaceVectorOf<Number> select(const Condition<Number>& condition, const SpaceVectorOf<Number>& a,
                             const SpaceVectorOf<Number>& b) noexcept {
  return {select(condition, a.re, b.re), select(condition, a.im, b.im)};
}

/// Its values in the phases U, V, W.
template <class Number>
constexpr std::array<Number, 3> phase_values(const SpaceVectorOf<Number>& a) noexcept {
  constexpr double kHalfSqrt3 = 0.5 * std::numbers::sqrt3;
  return {a.re, -0.5 * a.re + kHalfSqrt3 * a.im, -0.5 * a.re - kHalfSqrt3 * a.im};
}
/// The vector of the values @p phases in U, V, W; what they have in common is no part of it.
template <class Number>
constexpr SpaceVectorOf<Number> vector_of(const std::array<Number, 3>& phases) noexcept {
  constexpr double kThirdSqrt3 = std::numbers::inv_sqrt3;
  return {(2.0 * phases[0] - phases[1] - phases[2]) / 3.0, (phases[1] - phases[2]) * kThirdSqrt3};
}

}  // namespace motor
