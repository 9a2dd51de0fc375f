#include "drive/parameter/bico_text.hpp"

#include <fmt/format.h>

#include "text/number.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kHighestPosition = 0x3FF;

/// The number at the start of @p text, @p low to @p high; @p text loses it.
std::optional<std::uint16_t> take_number(std::string_view& text, std::uint16_t low, std::uint16_t high) noexcept {
  std::string_view rest = text;
  const auto number = text::take_integer<std::uint16_t>(rest);
  if (!number || *number < low || *number > high) return std::nullopt;
  text = rest;
  return number;
}

/// Takes @p word away from the start of @p text if it is there.
bool take(std::string_view& text, std::string_view word) noexcept {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

/// The bit or index behind the number of a source, 0 if there is none.
std::optional<std::uint16_t> take_position(std::string_view& text, DataType input) noexcept {
  const bool bit = input == DataType::BinectorInput;
  if (!take(text, bit ? "." : "[")) return std::uint16_t{0};
  const auto position = take_number(text, 0, kHighestPosition);
  if (!position || (!bit && !take(text, "]"))) return std::nullopt;
  return position;
}

/// The drive object behind a source, its own if none is named.
std::optional<std::uint8_t> take_owner(std::string_view& text, std::uint8_t first_axis) noexcept {
  if (take(text, " of drive object ")) return take_number(text, kControlUnitNumber, kOwnObject - 1);
  if (!take(text, " of axis ")) return kOwnObject;
  const auto axis = take_number(text, 1, kMostAxes);
  return axis ? std::optional{static_cast<std::uint8_t>(first_axis + *axis - 1)} : std::nullopt;
}

}  // namespace

std::string bico_text(const BicoSource& source, DataType input, std::uint8_t own) {
  const std::string at = input == DataType::BinectorInput
                             ? fmt::format("r{:04}.{}", source.number, source.position)
                             : fmt::format("r{:04}[{}]", source.number, source.position);
  const bool is_own = source.object == kOwnObject || source.object == own;
  return is_own ? at : fmt::format("{} of drive object {}", at, source.object);
}

std::optional<std::uint32_t> parse_bico(std::string_view text, DataType input, std::uint8_t first_axis) noexcept {
  if (text == "0") return 0;
  if (text == "1") return 1;
  if (!take(text, "r") && !take(text, "p")) return std::nullopt;
  const auto number = take_number(text, 1, UINT16_MAX);
  if (!number) return std::nullopt;
  const auto position = take_position(text, input);
  if (!position) return std::nullopt;
  const auto owner = take_owner(text, first_axis);
  if (!owner || !text.empty()) return std::nullopt;
  return pack({*number, *owner, *position});
}

}  // namespace drive
