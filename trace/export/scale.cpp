#include "trace/export/scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace trace {
namespace {

constexpr int kTicksOfAnAxis = 5;

}  // namespace

double round_step(double span, int count) noexcept {
  const double wanted = span / count;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= wanted * (1.0 - 1e-9)) return factor * power;
  return 10.0 * power;
}

Scale Scale::around(double low, double high, double from, double to) noexcept {
  if (!(low <= high)) low = high = 0.0;
  const double least = std::max(1e-9, 1e-6 * std::max(std::abs(low), std::abs(high)));
  if (high - low < least) {
    // A constant, in the middle of what makes its digits readable.
    const double room = std::max(least, 0.1 * std::abs(low));
    low -= low == 0.0 ? 1.0 : room;
    high += high == 0.0 ? 1.0 : room;
  }
  const double step = round_step(high - low, kTicksOfAnAxis);
  return {step * std::floor(low / step + 1e-6), step * std::ceil(high / step - 1e-6), from, to};
}

std::vector<double> Scale::ticks(int count) const {
  const double step = round_step(high_ - low_, count);
  std::vector<double> values;
  const double first = std::ceil(low_ / step - 1e-6);
  for (double k = first; k * step <= high_ + 1e-6 * step; k += 1.0) values.push_back(k * step);
  return values;
}

std::string tick_text(double value, double step) {
  constexpr double kHighestPlain = 1e6;
  if (std::abs(value) < 1e-9 * step) value = 0.0;
  if (std::abs(value) >= kHighestPlain || step < 1e-6) return fmt::format("{:.4g}", value);
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  return fmt::format("{:.{}f}", value, digits);
}

}  // namespace trace
