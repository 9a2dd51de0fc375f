#pragma once

#include <cstddef>

#include "motor/math/space_vector.hpp"

namespace motor {

/// Two numbers that are calculated side by side, as every x86-64 and ARMv8 can: the components of a vector.
using Pair = double __attribute__((vector_size(16)));

/// The same where lanes are side by side already.
template <class Number>
struct LanePair {
  Number first;
  Number second;

  const Number& operator[](std::size_t i) const noexcept { return i == 0 ? first : second; }
  friend LanePair operator+(const LanePair& a, const LanePair& b) noexcept {
    return {a.first + b.first, a.second + b.second};
  }
  friend LanePair operator-(const LanePair& a, const LanePair& b) noexcept {
    return {a.first - b.first, a.second - b.second};
  }
  friend LanePair operator*(const LanePair& a, const LanePair& b) noexcept {
    return {a.first * b.first, a.second * b.second};
  }
  friend LanePair operator*(const Number& a, const LanePair& b) noexcept { return {a * b.first, a * b.second}; }
  friend LanePair operator-(const Number& a, const LanePair& b) noexcept { return {a - b.first, a - b.second}; }
  LanePair& operator+=(const LanePair& b) noexcept { return *this = *this + b; }
};

template <class Number>
using PairOf = std::conditional_t<std::is_same_v<Number, double>, Pair, LanePair<Number>>;

/// The components of @p a.
template <class Number>
[[gnu::always_inline]] inline PairOf<Number> pair(const SpaceVectorOf<Number>& a) noexcept {
  return PairOf<Number>{a.re, a.im};
}
/// The vector with the components @p a.
[[gnu::always_inline]] inline SpaceVector vector(Pair a) noexcept {
  return {a[0], a[1]};
}
template <class Number>
[[gnu::always_inline]] inline SpaceVectorOf<Number> vector(const LanePair<Number>& a) noexcept {
  return {a.first, a.second};
}
/// The components exchanged.
[[gnu::always_inline]] inline Pair swapped(Pair a) noexcept {
  return __builtin_shufflevector(a, a, 1, 0);
}
template <class Number>
[[gnu::always_inline]] inline LanePair<Number> swapped(const LanePair<Number>& a) noexcept {
  return {a.second, a.first};
}
/// @p a twice.
template <class Number>
[[gnu::always_inline]] inline PairOf<Number> both(const Number& a) noexcept {
  return PairOf<Number>{a, a};
}
/// Two constants.
template <class Number>
[[gnu::always_inline]] inline PairOf<Number> constants(double first, double second) noexcept {
  return PairOf<Number>{Number{first}, Number{second}};
}
[[gnu::always_inline]] inline double sum(Pair a) noexcept {
  return a[0] + a[1];
}
template <class Number>
[[gnu::always_inline]] inline Number sum(const LanePair<Number>& a) noexcept {
  return a.first + a.second;
}
/// First component less the second.
[[gnu::always_inline]] inline double difference(Pair a) noexcept {
  return a[0] - a[1];
}
template <class Number>
[[gnu::always_inline]] inline Number difference(const LanePair<Number>& a) noexcept {
  return a.first - a.second;
}
/// Real part of a·conj(b).
[[gnu::always_inline]] inline double dot(Pair a, Pair b) noexcept {
  return sum(a * b);
}
template <class Number>
[[gnu::always_inline]] inline Number dot(const LanePair<Number>& a, const LanePair<Number>& b) noexcept {
  return sum(a * b);
}
/// Imaginary part of conj(a)·b.
[[gnu::always_inline]] inline double cross(Pair a, Pair b) noexcept {
  return difference(a * swapped(b));
}
template <class Number>
[[gnu::always_inline]] inline Number cross(const LanePair<Number>& a, const LanePair<Number>& b) noexcept {
  return difference(a * swapped(b));
}
/// @p a where @p condition holds, @p b elsewhere.
[[gnu::always_inline]] inline Pair select(bool condition, Pair a, Pair b) noexcept {
  return condition ? a : b;
}
template <class Number>
[[gnu::always_inline]] inline LanePair<Number> select(const Condition<Number>& condition,
                                                      const LanePair<Number>& a,
                                                      const LanePair<Number>& b) noexcept {
  return {select(condition, a.first, b.first), select(condition, a.second, b.second)};
}
/// Turned back by the angle whose cosine and sine are @p c and @p s.
template <class Number>
[[gnu::always_inline]] inline PairOf<Number> turned_back(const PairOf<Number>& a, const Number& c,
                                                         const Number& s) noexcept {
  return both(c) * a + PairOf<Number>{s, -s} * swapped(a);
}
/// Turned back by an angle whose square does not count (rad).
template <class Number>
[[gnu::always_inline]] inline PairOf<Number> turned_back_a_little(const PairOf<Number>& a,
                                                                  const Number& angle) noexcept {
  return a + PairOf<Number>{angle, -angle} * swapped(a);
}

}  // namespace motor
