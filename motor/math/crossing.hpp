#pragma once

namespace motor {

/// Where the rising @p function crosses zero between @p lower and @p upper, by bisection; the nearer end where it
/// does not.
template <class Function>
double crossing(double lower, double upper, Function function) noexcept {
  constexpr int kHalvings = 48;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (lower + upper);
    (function(middle) < 0.0 ? lower : upper) = middle;
  }
  return 0.5 * (lower + upper);
}

}  // namespace motor
