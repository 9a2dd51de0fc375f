#pragma once

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "text/number.hpp"

namespace text {

/// A unit that people write behind a time.
struct DurationUnit {
  std::string_view name;
  double nanoseconds;
};
/// From the shortest to the longest.
inline constexpr std::array kDurationUnits{DurationUnit{"ns", 1},     DurationUnit{"us", 1e3},
                                           DurationUnit{"ms", 1e6},   DurationUnit{"s", 1e9},
                                           DurationUnit{"min", 6e10}, DurationUnit{"h", 3.6e12}};

/// The time that all of @p words are, a number and one of @p units, "1.5s", to the nanosecond; nothing if they are
/// none, shorter than 1 ns or longer than @p longest.
inline std::optional<std::chrono::nanoseconds> duration(
    std::string_view words, std::chrono::nanoseconds longest,
    std::span<const DurationUnit> units = kDurationUnits) noexcept {
  const std::size_t unit_begin = words.find_last_not_of("abcdefghijklmnopqrstuvwxyz") + 1;
  const auto number = real(words.substr(0, unit_begin));
  for (const DurationUnit& unit : units) {
    if (!number || words.substr(unit_begin) != unit.name) continue;
    const double time = std::round(*number * unit.nanoseconds);
    if (!(time >= 1) || time > static_cast<double>(longest.count())) return std::nullopt;
    return std::chrono::nanoseconds{static_cast<std::int64_t>(time)};
  }
  return std::nullopt;
}

}  // namespace text
