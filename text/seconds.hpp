#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "text/number.hpp"

namespace text {

/// Takes seconds off the start of @p rest: digits, and behind a dot one to nine more, "1700000000.123456", exact
/// to the nanosecond. Nothing, and @p rest as it was, if there are none, or more than 9 000 000 000 of them.
inline std::optional<std::chrono::nanoseconds> take_seconds(std::string_view& rest) noexcept {
  constexpr std::uint64_t kMost = 9'000'000'000;
  constexpr std::size_t kDigits = 9;
  std::string_view ahead = rest;
  const auto whole = take_integer<std::uint64_t>(ahead);
  if (!whole || *whole > kMost) return std::nullopt;
  std::chrono::nanoseconds time = std::chrono::seconds{*whole};
  if (ahead.starts_with('.')) {
    ahead.remove_prefix(1);
    const std::size_t length = ahead.size();
    const auto fraction = take_integer<std::uint64_t>(ahead);
    const std::size_t digits = length - ahead.size();
    if (!fraction || digits > kDigits) return std::nullopt;
    std::uint64_t nanoseconds = *fraction;
    for (std::size_t i = digits; i < kDigits; ++i) nanoseconds *= 10;
    time += std::chrono::nanoseconds{nanoseconds};
  }
  rest = ahead;
  return time;
}

/// The seconds that all of @p digits spell.
inline std::optional<std::chrono::nanoseconds> seconds(std::string_view digits) noexcept {
  const auto time = take_seconds(digits);
  return digits.empty() ? time : std::nullopt;
}

}  // namespace text
