#include "eds/catalogue/number.hpp"

#include <cmath>
#include <limits>

#include "eds/document/value.hpp"
#include "text/number.hpp"

namespace eds {
namespace {

constexpr std::int64_t kFirstNode = 1;
constexpr std::int64_t kLastNode = 127;

/// True for what the catalogue may write of all the forms of an EDS: no blanks, $NODEID in front.
bool is_plain(std::string_view text, const IntegerText& number) {
  if (text.find_first_of(" \t") != std::string_view::npos || text.starts_with('+')) return false;
  return !number.node_relative || (text.starts_with("$NODEID+") && !number.value.negative);
}

}  // namespace

std::optional<Number> parse_number(std::string_view text) {
  const auto read = parse_integer(text);
  if (!read || !is_plain(text, *read) || read->value.magnitude > std::numeric_limits<std::uint32_t>::max())
    return std::nullopt;
  const auto magnitude = static_cast<std::int64_t>(read->value.magnitude);
  return Number{.value = read->value.negative ? -magnitude : magnitude,
                .node_relative = read->node_relative,
                .text = std::string{text}};
}

std::optional<Number> parse_real(std::string_view text) {
  const auto real = text::real(text, std::chars_format::fixed);
  if (!real || !std::isfinite(*real)) return std::nullopt;
  return Number{.real = *real, .text = std::string{text}};
}

std::optional<std::uint32_t> parse_hexadecimal(std::string_view text, std::size_t digits) {
  return text.size() == digits ? text::integer<std::uint32_t>(text, 16) : std::nullopt;
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
