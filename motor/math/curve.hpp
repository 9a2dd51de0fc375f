#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

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
    const double place = std::min(kLast, std::max(0.0, argument * scale_));
    const auto index = static_cast<std::size_t>(static_cast<int>(place));
    const double share = place - static_cast<double>(static_cast<int>(index));
    return values_[index] + share * (values_[index + 1] - values_[index]);
  }

 private:
  static constexpr double kLast = static_cast<double>(kIntervals) - 1e-9;

  std::array<double, kIntervals + 1> values_{};
  double scale_ = 1.0;
};

}  // namespace motor
