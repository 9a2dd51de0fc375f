#include "daemon/control/objects/object_value.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "libcanopen/od/abort_text.hpp"
#include "text/number.hpp"

namespace axisd {
namespace {

using canopen::AbortCode;
using canopen::DataType;
using control::ErrorCode;
using nlohmann::json;

struct TypeText {
  DataType type;
  std::string_view text;
};
constexpr std::array kTypes{
    TypeText{DataType::Boolean, "BOOLEAN"},
    TypeText{DataType::Integer8, "INTEGER8"},
    TypeText{DataType::Integer16, "INTEGER16"},
    TypeText{DataType::Integer32, "INTEGER32"},
    TypeText{DataType::Unsigned8, "UNSIGNED8"},
    TypeText{DataType::Unsigned16, "UNSIGNED16"},
    TypeText{DataType::Unsigned32, "UNSIGNED32"},
    TypeText{DataType::Real32, "REAL32"},
    TypeText{DataType::VisibleString, "VISIBLE_STRING"},
    TypeText{DataType::OctetString, "OCTET_STRING"},
    TypeText{DataType::UnicodeString, "UNICODE_STRING"},
    TypeText{DataType::TimeOfDay, "TIME_OF_DAY"},
    TypeText{DataType::TimeDifference, "TIME_DIFFERENCE"},
    TypeText{DataType::Domain, "DOMAIN"},
    TypeText{DataType::Integer24, "INTEGER24"},
    TypeText{DataType::Real64, "REAL64"},
    TypeText{DataType::Integer40, "INTEGER40"},
    TypeText{DataType::Integer48, "INTEGER48"},
    TypeText{DataType::Integer56, "INTEGER56"},
    TypeText{DataType::Integer64, "INTEGER64"},
    TypeText{DataType::Unsigned24, "UNSIGNED24"},
    TypeText{DataType::Unsigned40, "UNSIGNED40"},
    TypeText{DataType::Unsigned48, "UNSIGNED48"},
    TypeText{DataType::Unsigned56, "UNSIGNED56"},
    TypeText{DataType::Unsigned64, "UNSIGNED64"},
};

constexpr std::array<std::string_view, 6> kAccesses{"ro", "wo", "rw", "rwr", "rww", "const"};

/// Which error of the socket an abort code is; the others are refusals in the present state.
struct CodeRow {
  AbortCode abort;
  ErrorCode code;
};
constexpr std::array kCodes{
    CodeRow{AbortCode::NoObject, ErrorCode::NotFound},
    CodeRow{AbortCode::NoSubIndex, ErrorCode::NotFound},
    CodeRow{AbortCode::ReadOnly, ErrorCode::ReadOnly},
    CodeRow{AbortCode::InvalidValue, ErrorCode::OutOfRange},
    CodeRow{AbortCode::ValueTooHigh, ErrorCode::OutOfRange},
    CodeRow{AbortCode::ValueTooLow, ErrorCode::OutOfRange},
    CodeRow{AbortCode::LengthMismatch, ErrorCode::OutOfRange},
};

/// The whole numbers of a type.
struct WholeRange {
  std::int64_t low;
  std::uint64_t high;
};
WholeRange range_of(DataType type) noexcept {
  constexpr unsigned kLongest = 64;
  if (type == DataType::Boolean) return {0, 1};
  const unsigned bits = 8U * canopen::size_of(type);
  if (!canopen::is_signed(type)) return {0, std::numeric_limits<std::uint64_t>::max() >> (kLongest - bits)};
  const std::uint64_t high = std::numeric_limits<std::uint64_t>::max() >> (kLongest - bits + 1U);
  return {-static_cast<std::int64_t>(high) - 1, high};
}

/// The whole number that a text or a JSON value is, with its sign.
struct Whole {
  bool is_negative;
  std::uint64_t magnitude;
};
std::optional<Whole> whole_in(std::string_view text) noexcept {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
    base = 16;
  } else if (text.ends_with('h') || text.ends_with('H')) {
    text.remove_suffix(1);
    base = 16;
  }
  const auto magnitude = text::integer<std::uint64_t>(text, base);
  return magnitude ? std::optional{Whole{is_negative, *magnitude}} : std::nullopt;
}
std::optional<Whole> whole_in(const json& value) {
  if (value.is_boolean()) return Whole{false, value.get<bool>() ? 1U : 0U};
  if (value.is_string()) return whole_in(std::string_view{value.get_ref<const std::string&>()});
  if (value.is_number_unsigned()) return Whole{false, value.get<std::uint64_t>()};
  if (!value.is_number_integer()) return std::nullopt;
  const auto number = value.get<std::int64_t>();
  return Whole{number < 0,
               number < 0 ? 0U - static_cast<std::uint64_t>(number) : static_cast<std::uint64_t>(number)};
}

bool is_within(const Whole& whole, const WholeRange& range) noexcept {
  if (!whole.is_negative) return whole.magnitude <= range.high;
  return whole.magnitude <= 0U - static_cast<std::uint64_t>(range.low);
}

tl::unexpected<control::Error> out_of_range(const WholeRange& range, bool is_negative, const json& value) {
  const AbortCode abort = is_negative ? AbortCode::ValueTooLow : AbortCode::ValueTooHigh;
  return tl::unexpected{
      control::Error{ErrorCode::OutOfRange,
                     fmt::format("value: expected {} to {}, got {}", range.low, range.high, shown(value)),
                     {{"limits", {{"minimum", range.low}, {"maximum", range.high}}},
                      {"abort_code", static_cast<std::uint32_t>(abort)}}}};
}

Taken<std::int64_t> real_from(DataType type, const json& value) {
  std::optional<double> number;
  if (value.is_number()) number = value.get<double>();
  if (value.is_string()) number = text::real(value.get_ref<const std::string&>());
  const bool is_single = type == DataType::Real32;
  const double highest =
      is_single ? static_cast<double>(std::numeric_limits<float>::max()) : std::numeric_limits<double>::max();
  if (!number || !(std::abs(*number) <= highest))
    return tl::unexpected{unexpected_value("value", "a number that the type can hold", &value)};
  if (is_single) return std::bit_cast<std::uint32_t>(static_cast<float>(*number));
  return std::bit_cast<std::int64_t>(*number);
}

bool is_real(DataType type) noexcept {
  return type == DataType::Real32 || type == DataType::Real64;
}

}  // namespace

std::string_view type_text(DataType type) noexcept {
  const auto* const row = std::ranges::find(kTypes, type, &TypeText::type);
  return row != kTypes.end() ? row->text : std::string_view{};
}

std::string_view access_text(canopen::Access access) noexcept {
  return kAccesses[static_cast<std::size_t>(access)];
}

json number_json(DataType type, std::int64_t number) {
  if (type == DataType::Real32) return std::bit_cast<float>(static_cast<std::uint32_t>(number));
  if (type == DataType::Real64) return std::bit_cast<double>(number);
  if (canopen::is_signed(type)) return number;
  return static_cast<std::uint64_t>(number);
}

json text_json(DataType type, std::span<const std::uint8_t> bytes) {
  const bool is_text = type == DataType::VisibleString &&
                       std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte >= 0x20 && byte < 0x7F; });
  if (is_text) return std::string{bytes.begin(), bytes.end()};
  return fmt::format("{:02X}", fmt::join(bytes, ""));
}

Taken<std::int64_t> number_from(DataType type, const json& value) {
  if (is_real(type)) return real_from(type, value);
  const auto whole = whole_in(value);
  if (!whole) return tl::unexpected{unexpected_value("value", "an integer, decimal or as 0x1F or 1Fh", &value)};
  const WholeRange range = range_of(type);
  if (!is_within(*whole, range)) return out_of_range(range, whole->is_negative, value);
  return static_cast<std::int64_t>(whole->is_negative ? 0U - whole->magnitude : whole->magnitude);
}

Taken<std::vector<std::uint8_t>> text_from(DataType type, const json& value) {
  if (!value.is_string()) return tl::unexpected{unexpected_value("value", "a text", &value)};
  const auto& text = value.get_ref<const std::string&>();
  if (type == DataType::VisibleString) return std::vector<std::uint8_t>{text.begin(), text.end()};
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = 0; at < text.size(); at += 2) {
    const auto byte = text::integer<std::uint8_t>(std::string_view{text}.substr(at, 2), 16);
    if (!byte || at + 1 == text.size())
      return tl::unexpected{unexpected_value("value", "bytes in hexadecimal as 01AB", &value)};
    bytes.push_back(*byte);
  }
  return bytes;
}

control::Error refusal_of(AbortCode code, const ObjectAddress& address) {
  const auto* const row = std::ranges::find(kCodes, code, &CodeRow::abort);
  const std::string_view text = canopen::text_of(code);
  return {row != kCodes.end() ? row->code : ErrorCode::Refused,
          fmt::format("{}: {} ({:08X}h)", address_text(address), text, static_cast<std::uint32_t>(code)),
          {{"abort_code", static_cast<std::uint32_t>(code)}, {"abort_text", text}}};
}

}  // namespace axisd
