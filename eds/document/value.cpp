#include "eds/document/value.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "eds/document/encoding.hpp"
#include "text/number.hpp"

namespace eds {
namespace {

constexpr std::array kTypes{
    DataTypeRow{0x01, "BOOLEAN", ValueKind::Unsigned, 1},
    DataTypeRow{0x02, "INTEGER8", ValueKind::Signed, 8},
    DataTypeRow{0x03, "INTEGER16", ValueKind::Signed, 16},
    DataTypeRow{0x04, "INTEGER32", ValueKind::Signed, 32},
    DataTypeRow{0x05, "UNSIGNED8", ValueKind::Unsigned, 8},
    DataTypeRow{0x06, "UNSIGNED16", ValueKind::Unsigned, 16},
    DataTypeRow{0x07, "UNSIGNED32", ValueKind::Unsigned, 32},
    DataTypeRow{0x08, "REAL32", ValueKind::Real, 32},
    DataTypeRow{0x09, "VISIBLE_STRING", ValueKind::Text, 0},
    DataTypeRow{0x0A, "OCTET_STRING", ValueKind::Bytes, 0},
    DataTypeRow{0x0B, "UNICODE_STRING", ValueKind::Text, 0},
    DataTypeRow{0x0C, "TIME_OF_DAY", ValueKind::Unsigned, 48},
    DataTypeRow{0x0D, "TIME_DIFFERENCE", ValueKind::Unsigned, 48},
    DataTypeRow{0x0F, "DOMAIN", ValueKind::Bytes, 0},
    DataTypeRow{0x10, "INTEGER24", ValueKind::Signed, 24},
    DataTypeRow{0x11, "REAL64", ValueKind::Real, 64},
    DataTypeRow{0x12, "INTEGER40", ValueKind::Signed, 40},
    DataTypeRow{0x13, "INTEGER48", ValueKind::Signed, 48},
    DataTypeRow{0x14, "INTEGER56", ValueKind::Signed, 56},
    DataTypeRow{0x15, "INTEGER64", ValueKind::Signed, 64},
    DataTypeRow{0x16, "UNSIGNED24", ValueKind::Unsigned, 24},
    DataTypeRow{0x18, "UNSIGNED40", ValueKind::Unsigned, 40},
    DataTypeRow{0x19, "UNSIGNED48", ValueKind::Unsigned, 48},
    DataTypeRow{0x1A, "UNSIGNED56", ValueKind::Unsigned, 56},
    DataTypeRow{0x1B, "UNSIGNED64", ValueKind::Unsigned, 64},
};
static_assert(std::ranges::is_sorted(kTypes, {}, &DataTypeRow::number));

struct Limits {
  Integer low, high;
};

Limits limits_of(const DataTypeRow& type) {
  const std::uint64_t all = std::numeric_limits<std::uint64_t>::max() >> (64U - type.bits);
  if (type.kind == ValueKind::Unsigned) return {{}, {.magnitude = all}};
  return {{.magnitude = (all >> 1U) + 1, .negative = true}, {.magnitude = all >> 1U}};
}

std::optional<IntegerText> parse_plain(std::string_view text) noexcept {
  text = trimmed(text);
  IntegerText number;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  number.hexadecimal = take_in_any_case(text, "0x");
  const bool octal = !number.hexadecimal && text.size() > 1 && text.starts_with('0');
  const auto magnitude = text::integer<std::uint64_t>(text, number.hexadecimal ? 16 : octal ? 8 : 10);
  if (!magnitude) return std::nullopt;
  number.value.magnitude = *magnitude;
  number.value.negative = negative && number.value.magnitude != 0;
  return number;
}

/// True when @p text names the node-ID and nothing else.
bool is_node_id(std::string_view text) noexcept {
  return equal_in_any_case(trimmed(text), "$NODEID");
}

std::string range_text(const DataTypeRow& type) {
  const Limits limits = limits_of(type);
  return fmt::format("a value of {} ({}..{})", type.name, to_text(limits.low), to_text(limits.high));
}

tl::expected<Value, ValueError> parse_number(std::string_view text, const DataTypeRow& type, NodeRange nodes) {
  const auto number = parse_integer(text);
  if (!number) return tl::unexpected{ValueError{false, range_text(type)}};
  const Limits limits = limits_of(type);
  Value value{.kind = type.kind, .integer = number->value, .node_relative = number->node_relative, .text = {}};
  const std::uint64_t pattern = number->value.magnitude;
  const std::uint64_t all = limits.high.magnitude + limits.low.magnitude;
  const bool complement = type.kind == ValueKind::Signed && number->hexadecimal && !number->value.negative &&
                          pattern > limits.high.magnitude && pattern <= all;
  if (complement) value.integer = {.magnitude = all - pattern + 1, .negative = true};
  const auto highest = value.at(nodes.last);
  if (value.integer < limits.low || !highest || *highest > limits.high)
    return tl::unexpected{ValueError{true, range_text(type)}};
  return value;
}

tl::expected<Value, ValueError> parse_real(std::string_view text, const DataTypeRow& type) {
  const ValueError error{false, fmt::format("a value of {}", type.name)};
  std::string_view digits = trimmed(text);
  Value value{.kind = ValueKind::Real, .integer = {}, .text = {}};
  if (const auto pattern = parse_plain(digits); pattern && pattern->hexadecimal) {
    const std::uint64_t bits = pattern->value.magnitude;
    if (pattern->value.negative || (type.bits == 32 && bits > std::numeric_limits<std::uint32_t>::max()))
      return tl::unexpected{ValueError{true, error.expected}};
    value.real = type.bits == 32 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                                 : std::bit_cast<double>(bits);
    if (!std::isfinite(value.real)) return tl::unexpected{ValueError{true, error.expected}};
    return value;
  }
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const char* const end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, value.real);
  if (code == std::errc::invalid_argument || stop != end) return tl::unexpected{error};
  const bool too_large =
      type.bits == 32 && std::abs(value.real) > static_cast<double>(std::numeric_limits<float>::max());
  if (code != std::errc{} || !std::isfinite(value.real) || too_large)
    return tl::unexpected{ValueError{true, error.expected}};
  return value;
}

bool is_hexadecimal(char c) noexcept {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

tl::expected<Value, ValueError> parse_bytes(std::string_view text, const DataTypeRow& type) {
  std::size_t digits = 0;
  for (const char c : text) {
    if (is_hexadecimal(c)) {
      ++digits;
    } else if (c != ' ' || digits % 2 != 0) {
      digits = 1;
      break;
    }
  }
  if (digits % 2 != 0)
    return tl::unexpected{ValueError{false, fmt::format("pairs of hexadecimal digits for {}", type.name)}};
  return Value{.kind = ValueKind::Bytes, .integer = {}, .text = std::string{text}};
}

}  // namespace

std::strong_ordering operator<=>(const Integer& one, const Integer& other) noexcept {
  if (one.negative != other.negative) return other.negative <=> one.negative;
  return one.negative ? other.magnitude <=> one.magnitude : one.magnitude <=> other.magnitude;
}

std::optional<IntegerText> parse_integer(std::string_view text) noexcept {
  if (is_node_id(text)) return IntegerText{.value = {}, .node_relative = true};
  const std::size_t plus = text.find('+');
  if (plus == std::string_view::npos) return parse_plain(text);
  const std::string_view before = text.substr(0, plus), behind = text.substr(plus + 1);
  if (is_node_id(before) == is_node_id(behind)) return parse_plain(text);
  auto number = parse_plain(is_node_id(before) ? behind : before);
  if (number) number->node_relative = number->sum = true;
  return number;
}

const DataTypeRow* find_data_type(std::uint64_t number) noexcept {
  const auto* const found = std::ranges::find(kTypes, number, &DataTypeRow::number);
  return found == kTypes.end() ? nullptr : found;
}

std::optional<Integer> Value::at(unsigned node_id) const noexcept {
  if (!node_relative) return integer;
  if (integer.negative)
    return integer.magnitude > node_id ? Integer{.magnitude = integer.magnitude - node_id, .negative = true}
                                       : Integer{.magnitude = node_id - integer.magnitude};
  if (integer.magnitude > std::numeric_limits<std::uint64_t>::max() - node_id) return std::nullopt;
  return Integer{.magnitude = integer.magnitude + node_id};
}

tl::expected<Value, ValueError> parse_value(std::string_view text, const DataTypeRow& type, NodeRange nodes) {
  switch (type.kind) {
    case ValueKind::Signed:
    case ValueKind::Unsigned:
      return parse_number(text, type, nodes);
    case ValueKind::Real:
      return parse_real(text, type);
    case ValueKind::Text:
      return Value{.kind = ValueKind::Text, .integer = {}, .text = std::string{text}};
    case ValueKind::Bytes:
      return parse_bytes(text, type);
  }
  return tl::unexpected{ValueError{}};
}

bool ordered(const Value& one, const Value& other, NodeRange nodes) noexcept {
  if (one.kind == ValueKind::Real) return one.real <= other.real;
  if (one.kind != ValueKind::Signed && one.kind != ValueKind::Unsigned) return true;
  return one.at(nodes.first) <= other.at(nodes.first) && one.at(nodes.last) <= other.at(nodes.last);
}

std::string with_sign(std::string_view written, const Value& value) {
  const bool hidden = value.integer.negative && !written.starts_with('-');
  return hidden ? fmt::format("{} ({})", written, to_text(value.integer)) : std::string{written};
}

std::string to_text(const Integer& integer) {
  return fmt::format("{}{}", integer.negative ? "-" : "", integer.magnitude);
}

}  // namespace eds
