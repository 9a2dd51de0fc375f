#pragma once

#include <cstddef>
#include <type_traits>

#include "motor/math/number.hpp"

// Two registers of lanes as one number: where one calculation has to wait for its last result, the other goes on.
namespace motor {

/// A condition for each lane of a Twin.
template <class Half>
struct TwinMask {
  using HalfMask = typename Half::mask_type;

  TwinMask() = default;
  explicit TwinMask(bool value) noexcept : first{value}, second{value} {}
  TwinMask(const HalfMask& a, const HalfMask& b) noexcept : first{a}, second{b} {}

  bool operator[](std::size_t lane) const noexcept {
    return lane < Half::size() ? first[lane] : second[lane - Half::size()];
  }
  friend TwinMask operator&&(const TwinMask& a, const TwinMask& b) noexcept {
    return {a.first && b.first, a.second && b.second};
  }
  friend TwinMask operator||(const TwinMask& a, const TwinMask& b) noexcept {
    return {a.first || b.first, a.second || b.second};
  }
  TwinMask operator!() const noexcept { return {!first, !second}; }
  friend bool any_of(const TwinMask& a) noexcept { return any_of(a.first || a.second); }
  friend bool all_of(const TwinMask& a) noexcept { return all_of(a.first && a.second); }

  HalfMask first;
  HalfMask second;
};

template <class Half>
struct Twin {
  using Mask = TwinMask<Half>;

  Twin() = default;
  Twin(double value) noexcept
      : first{value}, second{value} {}  // NOLINT(google-explicit-constructor): as of one number
  Twin(const Half& a, const Half& b) noexcept : first{a}, second{b} {}
  template <class Flag>
  Twin(const double* from, Flag flag) noexcept : first{from, flag}, second{from + Half::size(), flag} {}
  /// @p value gives the number of each lane, which it is told as a constant.
  template <class Value>
  requires requires(Value value) { value(std::integral_constant<std::size_t, 0>{}); }
  explicit Twin(Value value) noexcept
      : first{[&](auto lane) { return value(lane); }}, second{[&](auto lane) {
          return value(std::integral_constant<std::size_t, Half::size() + lane>{});
        }} {}

  static constexpr std::size_t size() noexcept { return 2 * Half::size(); }
  template <class Flag>
  void copy_to(double* to, Flag flag) const noexcept {
    first.copy_to(to, flag);
    second.copy_to(to + Half::size(), flag);
  }
  double operator[](std::size_t lane) const noexcept {
    return lane < Half::size() ? first[lane] : second[lane - Half::size()];
  }

  friend Twin operator+(const Twin& a, const Twin& b) noexcept { return {a.first + b.first, a.second + b.second}; }
  friend Twin operator-(const Twin& a, const Twin& b) noexcept { return {a.first - b.first, a.second - b.second}; }
  friend Twin operator*(const Twin& a, const Twin& b) noexcept { return {a.first * b.first, a.second * b.second}; }
  friend Twin operator/(const Twin& a, const Twin& b) noexcept { return {a.first / b.first, a.second / b.second}; }
  Twin operator-() const noexcept { return {-first, -second}; }
  Twin& operator+=(const Twin& b) noexcept { return *this = *this + b; }
  Twin& operator-=(const Twin& b) noexcept { return *this = *this - b; }
  Twin& operator*=(const Twin& b) noexcept { return *this = *this * b; }
  friend Mask operator<(const Twin& a, const Twin& b) noexcept { return {a.first < b.first, a.second < b.second}; }
  friend Mask operator>(const Twin& a, const Twin& b) noexcept { return {a.first > b.first, a.second > b.second}; }
  friend Mask operator<=(const Twin& a, const Twin& b) noexcept {
    return {a.first <= b.first, a.second <= b.second};
  }
  friend Mask operator>=(const Twin& a, const Twin& b) noexcept {
    return {a.first >= b.first, a.second >= b.second};
  }
  friend Mask operator==(const Twin& a, const Twin& b) noexcept {
    return {a.first == b.first, a.second == b.second};
  }
  friend Mask operator!=(const Twin& a, const Twin& b) noexcept {
    return {a.first != b.first, a.second != b.second};
  }

  friend Twin abs(const Twin& a) noexcept { return {abs(a.first), abs(a.second)}; }
  friend Twin sqrt(const Twin& a) noexcept { return {sqrt(a.first), sqrt(a.second)}; }
  friend Twin floor(const Twin& a) noexcept { return {floor(a.first), floor(a.second)}; }
  friend Twin copysign(const Twin& a, const Twin& b) noexcept {
    return {copysign(a.first, b.first), copysign(a.second, b.second)};
  }
  /// @p a where @p mask holds, @p b elsewhere.
  friend Twin chosen(const Mask& mask, const Twin& a, const Twin& b) noexcept {
    return {select<Half>(mask.first, a.first, b.first), select<Half>(mask.second, a.second, b.second)};
  }
  /// @p a where a < b, @p b elsewhere; @p a where a > b, @p b elsewhere.
  friend Twin lesser(const Twin& a, const Twin& b) noexcept requires requires(const Half& half) {
    lesser(half, half);
  }
  { return {lesser(a.first, b.first), lesser(a.second, b.second)}; }
  friend Twin greater(const Twin& a, const Twin& b) noexcept requires requires(const Half& half) {
    greater(half, half);
  }
  { return {greater(a.first, b.first), greater(a.second, b.second)}; }

  Half first;
  Half second;
};

}  // namespace motor
