#include "drive/reference/catalogue_rows.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "drive/catalogue/table.hpp"

namespace drive {
namespace {

constexpr unsigned kFirstObject = 0x2000;
constexpr unsigned kLastObject = 0x470F;
/// An EDS has no more; p8630[1] leads to the indices behind it.
constexpr unsigned kLastSubIndex = 0xFE;

/// Whether a server of a drive object shows @p row, whose number is that of an object.
bool is_an_object(const ParameterRow& row) {
  return kFirstObject + row.number <= kLastObject;
}

struct KindName {
  ObjectKind kind;
  std::string_view scope;
};
constexpr std::array kKinds{KindName{ObjectKind::ControlUnit, "cu-parameter"},
                            KindName{ObjectKind::Servo, "servo-parameter"},
                            KindName{ObjectKind::Vector, "vector-parameter"}};

/// The names of CiA 301, in the order of the types.
constexpr std::array<std::string_view, kDataTypes.size()> kTypeNames{"INTEGER8",   "UNSIGNED8",  "INTEGER16",
                                                                     "UNSIGNED16", "INTEGER32",  "UNSIGNED32",
                                                                     "REAL32",     "UNSIGNED32", "UNSIGNED32"};

/// @p value without exponent, as an EDS has numbers; a BICO source in hexadecimal, its parts show.
std::string number(const ParameterRow& row, double value) {
  if (is_bico_input(row.type)) return fmt::format("0x{:08X}", static_cast<std::uint32_t>(value));
  if (row.type != DataType::F32) return fmt::format("{}", static_cast<std::int64_t>(value));
  std::string text = fmt::format("{:.9f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string field(std::string_view key, const std::optional<std::string>& value) {
  return value ? fmt::format(R"(, "{}": "{}")", key, *value) : "";
}

/// Default and limits of what can be written.
std::string values(const ParameterRow& row) {
  if (!row.is_writable()) return "";
  const auto* const factory = std::get_if<double>(&row.factory);
  const bool limited = row.range != kWhole && !is_bico_input(row.type);
  std::string fields;
  if (factory != nullptr) fields += field("default", number(row, *factory));
  if (limited)
    fields += field("low", number(row, row.range.minimum)) + field("high", number(row, row.range.maximum));
  return fields;
}

void write_row(std::string& list, const ParameterRow& row, std::string_view scope) {
  const auto out = std::back_inserter(list);
  const unsigned index = kFirstObject + row.number;
  const std::string_view separator = list.size() > 1 ? ",\n" : "\n";
  if (row.count == 1) {
    fmt::format_to(out, R"({}{{"index": "{:04X}", "sub": "00")", separator, index);
  } else {
    fmt::format_to(out, R"({}{{"index": "{:04X}", "object": "ARRAY", "scope": "{}", "name": "{}"}},)", separator,
                   index, scope, row.name);
    fmt::format_to(out,
                   "\n"
                   R"({{"index": "{:04X}", "sub": "00-{:02X}")",
                   index, std::min<unsigned>(row.count - 1U, kLastSubIndex));
  }
  fmt::format_to(
      out, R"(, "object": "VAR", "type": "{}", "access": "{}", "pdo": false{}, "scope": "{}", "name": "{}"}})",
      kTypeNames[static_cast<std::size_t>(row.type)], row.is_writable() ? "rw" : "ro", values(row), scope,
      row.name);
}

}  // namespace

std::string catalogue_rows() {
  std::string list{"["};
  for (const ParameterRow* row : parameter_rows())
    for (const auto& [kind, scope] : kKinds)
      if (contains(row->kinds, kind) && is_an_object(*row)) write_row(list, *row, scope);
  return list + "\n]\n";
}

}  // namespace drive
