#include "eds/number.hpp"

#include <charconv>
#include <cmath>

namespace eds {
namespace {

constexpr std::string_view kNodeId = "$NODEID+";
constexpr std::int64_t kFirstNode = 1;
constexpr std::int64_t kLastNode = 127;

bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

}  // namespace

std::optional<Number> parse_number(std::string_view text) {
  Number number{.text = std::string{text}};
  number.node_relative = take(text, kNodeId);
  const bool negative = !number.node_relative && take(text, "-");
  const int base = take(text, "0x") ? 16 : 10;
  std::uint32_t magnitude = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, magnitude, base);
  if (error != std::errc{} || stop != end) return std::nullopt;
  number.value = negative ? -std::int64_t{magnitude} : std::int64_t{magnitude};
  return number;
}

std::optional<Number> parse_real(std::string_view text) {
  double real = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, real, std::chars_format::fixed);
  if (error != std::errc{} || stop != end || !std::isfinite(real)) return std::nullopt;
  return Number{.real = real, .text = std::string{text}};
}

std::optional<std::uint32_t> parse_hexadecimal(std::string_view text, std::size_t digits) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, 16);
  if (text.size() != digits || error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<Range> range_of(canopen::DataType type) noexcept {
  const int bits = 8 * canopen::size_of(type);
  if (type == canopen::DataType::Boolean) return Range{0, 1};
  if (bits == 0 || bits > 32 || type == canopen::DataType::Real32) return std::nullopt;
  const std::int64_t values = std::int64_t{1} << bits;
  if (canopen::is_signed(type)) return Range{-values / 2, values / 2 - 1};
  return Range{0, values - 1};
}

bool within(const Number& number, const Range& range) noexcept {
  return number.at(kFirstNode) >= range.low && number.at(kLastNode) <= range.high;
}

bool ordered(const Number& smaller, const Number& larger) noexcept {
  return smaller.at(kFirstNode) <= larger.at(kFirstNode) && smaller.at(kLastNode) <= larger.at(kLastNode) &&
         smaller.real <= larger.real;
}

}  // namespace eds
