#pragma once

#include "motor/math/space_vector.hpp"

namespace motor {

/// Two numbers that are calculated side by side, as every x86-64 and ARMv8 can: the components of a vector.
using Pair = double __attribute__((vector_size(16)));

/// The components of @p a.
inline Pair pair(SpaceVector a) noexcept {
  return Pair{a.re, a.im};
}
/// The vector with the components @p a.
inline SpaceVector vector(Pair a) noexcept {
  return {a[0], a[1]};
}
/// The components exchanged.
inline Pair swapped(Pair a) noexcept {
  return __builtin_shufflevector(a, a, 1, 0);
}
/// @p a twice.
inline Pair both(double a) noexcept {
  return Pair{a, a};
}
inline double sum(Pair a) noexcept {
  return a[0] + a[1];
}
/// First component less the second.
inline double difference(Pair a) noexcept {
  return a[0] - a[1];
}
/// Real part of a·conj(b).
inline double dot(Pair a, Pair b) noexcept {
  return sum(a * b);
}
/// Imaginary part of conj(a)·b.
inline double cross(Pair a, Pair b) noexcept {
  return difference(a * swapped(b));
}
/// Turned back by the angle whose cosine and sine are @p c and @p s.
inline Pair turned_back(Pair a, double c, double s) noexcept {
  return both(c) * a + Pair{s, -s} * swapped(a);
}
/// Turned back by an angle whose square does not count (rad).
inline Pair turned_back_a_little(Pair a, double angle) noexcept {
  return a + Pair{angle, -angle} * swapped(a);
}

}  // namespace motor
