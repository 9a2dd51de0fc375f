#include "eds/writer/table_writer.hpp"

#include <iterator>

#include <fmt/format.h>

namespace eds {
namespace {

constexpr std::string_view kHead = R"(// Generated from the object catalogue, do not edit.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "libcanopen/od/entry_description.hpp"

)";

constexpr std::string_view kTypes = R"(using canopen::Access;
using canopen::DataType;
using canopen::LimitCheck;

/// Another initial value than that of the row.
struct OtherInitial {
  std::uint16_t index;
  std::uint8_t sub_index;
  std::int64_t initial;
};

)";

constexpr std::string_view kOffsetsHead = R"(// Generated from the object catalogue, do not edit.
#pragma once

#include <array>

#include "eds/catalogue/axis_rule.hpp"

)";

constexpr std::string_view kTail = R"(
/// Index and sub-index as one number, the order of the rows.
inline constexpr auto kObjectTableKey = [](const canopen::EntryDescription& entry) {
  return std::uint32_t{entry.index} << 8 | entry.sub_index;
};
static_assert(std::ranges::adjacent_find(kUnitTable, std::ranges::greater_equal{}, kObjectTableKey) ==
                      kUnitTable.end() &&
                  std::ranges::adjacent_find(kAxisTable, std::ranges::greater_equal{}, kObjectTableKey) ==
                      kAxisTable.end(),
              "lookup needs ascending rows");
)";

/// The rows of one array under construction.
struct Rows {
  std::string text;
  std::size_t count = 0;

  void add(std::string_view row) {
    text.append("    ").append(row).append(",\n");
    ++count;
  }
};

std::string array_of(std::string_view comment, std::string_view type, std::string_view name, const Rows& rows) {
  return fmt::format("/// {}\ninline constexpr std::array<{}, {}> {}{{{{\n{}}}}};\n\n", comment, type, rows.count,
                     name, rows.text);
}

/// The array of the rows of what is not in every catalogue; nothing where there are none.
std::string array_if_any(std::string_view comment, std::string_view name, const Rows& rows) {
  return rows.count == 0 ? "" : array_of(comment, "OtherInitial", name, rows);
}

std::string in_namespace(std::string_view name, const std::string& text) {
  return fmt::format("namespace {0} {{\n\n{1}\n}}  // namespace {0}\n", name, text);
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// Hexadecimal for what is never negative, as masters and manuals write it.
std::string literal(std::int64_t value, canopen::DataType type) {
  if (canopen::is_signed(type)) return fmt::format("{}", value);
  return fmt::format("0x{:0{}X}", value, 2 * canopen::size_of(type));
}

std::string limit(const std::optional<Number>& number, canopen::DataType type) {
  if (!number || number->node_relative) return "std::nullopt";
  return literal(number->value, type);
}

std::string entry_row(const Object& object, const Entry& entry) {
  const bool is_text = canopen::size_of(entry.type) == 0;
  std::string text = fmt::format(
      "{{.index = 0x{:04X}, .sub_index = 0x{:02X}, .type = DataType::{}, .access = Access::{}", object.index,
      entry.sub_index, name_of(kDataTypes, entry.type).enumerator, name_of(kAccesses, entry.access).enumerator);
  if (entry.pdo_mappable) text += ", .pdo_mappable = true";
  if (entry.initial.node_relative) text += ", .node_relative = true";
  if (entry.limit_check == canopen::LimitCheck::Owner) text += ", .limit_check = LimitCheck::Owner";
  return text + fmt::format(", .initial = {}, .low = {}, .high = {}, .text = {}, .name = {}}}",
                            is_text ? "0" : literal(entry.initial.value, entry.type), limit(entry.low, entry.type),
                            limit(entry.high, entry.type), quoted(is_text ? entry.initial.text : ""),
                            quoted(entry.name));
}

Rows entry_rows(const Catalogue& catalogue, Scope scope) {
  Rows rows;
  for (const Object& object : catalogue.objects)
    if (object.scope == scope)
      for (const Entry& entry : object.entries) rows.add(entry_row(object, entry));
  return rows;
}

/// The rows of the entries that have another initial value at @p variant.
Rows other_rows(const Catalogue& catalogue, std::optional<Number> Entry::*variant) {
  Rows rows;
  for (const Object& object : catalogue.objects)
    for (const Entry& entry : object.entries)
      if (const auto& other = entry.*variant)
        rows.add(fmt::format("{{.index = 0x{:04X}, .sub_index = 0x{:02X}, .initial = {}}}", object.index,
                             entry.sub_index, literal(other->value, entry.type)));
  return rows;
}

Rows offset_rows(const Catalogue& catalogue) {
  Rows rows;
  for (const AxisOffset& row : catalogue.axis_offsets)
    rows.add(fmt::format("{{.first = 0x{:04X}, .last = 0x{:04X}, .offset = 0x{:04X}}}", row.first, row.last,
                         row.offset));
  return rows;
}

}  // namespace

std::string write_table(const Catalogue& catalogue, std::string_view name_space) {
  constexpr std::string_view kEntry = "canopen::EntryDescription";
  const std::string text =
      std::string{kTypes} +
      array_of("The entries that a unit has once, ascending by index and sub-index.", kEntry, "kUnitTable",
               entry_rows(catalogue, Scope::Unit)) +
      array_of("The entries of axis 1 as a servo axis, ascending likewise.", kEntry, "kAxisTable",
               entry_rows(catalogue, Scope::Axis)) +
      array_if_any("Initial values of axes 2 to 8 that are not those of axis 1, under its indices.",
                   "kOtherAxesInitials", other_rows(catalogue, &Entry::other_axes)) +
      array_if_any("Initial values of vector axes that are not those of servo axes, under the indices of axis 1.",
                   "kVectorInitials", other_rows(catalogue, &Entry::vector)) +
      array_if_any("Initial values that are not those of a unit with one axis, where there are several.",
                   "kSeveralAxesInitials", other_rows(catalogue, &Entry::several_axes)) +
      std::string{kTail};
  return std::string{kHead} + in_namespace(name_space, text);
}

std::string write_offsets(const Catalogue& catalogue, std::string_view name_space) {
  const std::string text =
      array_of("Where the other axes have their objects.", "eds::AxisOffset", "kAxisOffsets",
               offset_rows(catalogue)) +
      fmt::format("/// Axes that a unit has at most.\ninline constexpr unsigned kMostAxes = {};\n", kMostAxes);
  return std::string{kOffsetsHead} + in_namespace(name_space, text);
}

}  // namespace eds
