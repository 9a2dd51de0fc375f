#include "eds/table_writer.hpp"

#include <algorithm>
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

namespace device::generated {{

using canopen::Access;
using canopen::DataType;
using canopen::LimitCheck;

/// Every entry that the unit serves, ascending by index and sub-index.
inline constexpr std::array<canopen::EntryDescription, {}> kObjectTable{{{{
)";

constexpr std::string_view kTail = R"(}};

/// Index and sub-index as one number, the order of the rows.
inline constexpr auto kObjectTableKey = [](const canopen::EntryDescription& entry) {
  return std::uint32_t{entry.index} << 8 | entry.sub_index;
};
static_assert(std::ranges::adjacent_find(kObjectTable, std::ranges::greater_equal{}, kObjectTableKey) ==
                  kObjectTable.end(),
              "lookup needs ascending rows");

}  // namespace device::generated
)";

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

std::string row(const Object& object, const Entry& entry) {
  const bool is_text = canopen::size_of(entry.type) == 0;
  std::string text = fmt::format(
      "    {{.index = 0x{:04X}, .sub_index = 0x{:02X}, .type = DataType::{}, .access = Access::{}", object.index,
      entry.sub_index, name_of(kDataTypes, entry.type).enumerator, name_of(kAccesses, entry.access).enumerator);
  if (entry.pdo_mappable) text += ", .pdo_mappable = true";
  if (entry.initial.node_relative) text += ", .node_relative = true";
  if (entry.limit_check == canopen::LimitCheck::Owner) text += ", .limit_check = LimitCheck::Owner";
  return text + fmt::format(", .initial = {}, .low = {}, .high = {}, .text = {}, .name = {}}},\n",
                            is_text ? "0" : literal(entry.initial.value, entry.type), limit(entry.low, entry.type),
                            limit(entry.high, entry.type), quoted(is_text ? entry.initial.text : ""),
                            quoted(entry.name));
}

}  // namespace

std::string write_table(const Catalogue& catalogue) {
  std::string rows;
  std::size_t count = 0;
  for (const Object& object : catalogue.objects) {
    for (const Entry& entry : object.entries) rows += row(object, entry);
    count += object.entries.size();
  }
  return fmt::format(fmt::runtime(kHead), count) + rows + std::string{kTail};
}

}  // namespace eds
