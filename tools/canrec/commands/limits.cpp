#include "tools/canrec/commands/limits.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "text/number.hpp"
#include "text/seconds.hpp"

namespace canrec {

namespace {

struct Unit {
  std::string_view letter;
  std::int64_t factor;
};
constexpr std::array kTimes{Unit{"", 1}, Unit{"s", 1}, Unit{"m", 60}, Unit{"h", 60 * 60}, Unit{"d", 24 * 60 * 60}};
constexpr std::int64_t kStep = 1024;
constexpr std::array kSizes{Unit{"", 1}, Unit{"k", kStep}, Unit{"M", kStep* kStep},
                            Unit{"G", kStep* kStep* kStep}};

/// @p number times the factor of @p letter, if there is such a unit and it is not too much.
std::optional<std::int64_t> scaled(std::int64_t number, std::string_view letter, std::span<const Unit> units) {
  const auto unit = std::ranges::find(units, letter, &Unit::letter);
  if (unit == units.end() || number > std::numeric_limits<std::int64_t>::max() / unit->factor) return std::nullopt;
  return number * unit->factor;
}

}  // namespace

std::optional<std::chrono::nanoseconds> read_age(std::string_view text) noexcept {
  const auto number = text::take_seconds(text);
  if (!number || number->count() == 0) return std::nullopt;
  const auto time = scaled(number->count(), text, kTimes);
  if (!time) return std::nullopt;
  return std::chrono::nanoseconds{*time};
}

std::optional<std::int64_t> read_bytes(std::string_view text) noexcept {
  const auto number = text::take_integer<std::int64_t>(text);
  return number && *number >= 0 ? scaled(*number, text, kSizes) : std::nullopt;
}

std::optional<double> read_speed(std::string_view text) noexcept {
  constexpr double kMost = 1e6;
  const auto speed = text::real(text);
  return speed && *speed > 0.0 && *speed <= kMost ? speed : std::nullopt;
}

}  // namespace canrec
