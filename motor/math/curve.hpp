#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "motor/math/number.hpp"

namespace motor {

/// A function by equally spaced values between 0 and an upper end, straight lines between them; arguments outside
/// take the value of the nearer end, one that is no number that at 0.
class Curve {
 public:
  static constexpr std::size_t kIntervals = 64;

  /// Takes the values of @p function at the nodes of 0..@p end (positive).
  template <class Function>
  void fill(double end, Function function) noexcept {
    scale_ = static_cast<double>(kIntervals) / end;
    for (std::size_t i = 0; i <= kIntervals; ++i) values_[i] = function(static_cast<double>(i) / scale_);
  }
  double at(double argument) const noexcept {
    const double place = place_of(argument, scale_);
    const auto index = static_cast<std::size_t>(static_cast<int>(place));
    const double share = place - static_cast<double>(static_cast<int>(index));
    return between(values_[index], values_[index + 1], share);
  }

  /// Where on a curve of @p scale an argument is, 0 to the number of intervals.
  template <class Number>
  static Number place_of(const Number& argument, const Number& scale) noexcept {
    return minimum<Number>(kLast, maximum<Number>(0.0, argument * scale));
  }
  /// The line from @p left to @p right at @p share of the way.
  template <class Number>
  static Number between(const Number& left, const Number& right, const Number& share) noexcept {
    return left + share * (right - left);
  }
  double scale() const noexcept { return scale_; }
  const std::array<double, kIntervals + 1>& values() const noexcept { return values_; }

 private:
  static constexpr double kLast = static_cast<double>(kIntervals) - 1e-9;

  std::array<double, kIntervals + 1> values_{};
  double scale_ = 1.0;
};

/// A curve for each lane, motor/lockstep.
template <class Number>
class LaneCurves;

template <class Number>
using CurveOf = std::conditional_t<std::is_same_v<Number, double>, Curve, LaneCurves<Number>>;

}  // namespace motor
