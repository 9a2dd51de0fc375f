#include "eds/transform/dictionary_source.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "eds/sheet/names.hpp"
#include "eds/sheet/object_lists.hpp"

namespace eds {
namespace {

struct TypeName {
  std::uint16_t number;
  std::string_view enumerator;
};
constexpr std::array kTypes{
    TypeName{0x01, "Boolean"},        TypeName{0x02, "Integer8"},      TypeName{0x03, "Integer16"},
    TypeName{0x04, "Integer32"},      TypeName{0x05, "Unsigned8"},     TypeName{0x06, "Unsigned16"},
    TypeName{0x07, "Unsigned32"},     TypeName{0x08, "Real32"},        TypeName{0x09, "VisibleString"},
    TypeName{0x0A, "OctetString"},    TypeName{0x0B, "UnicodeString"}, TypeName{0x0C, "TimeOfDay"},
    TypeName{0x0D, "TimeDifference"}, TypeName{0x0F, "Domain"},        TypeName{0x10, "Integer24"},
    TypeName{0x11, "Real64"},         TypeName{0x12, "Integer40"},     TypeName{0x13, "Integer48"},
    TypeName{0x14, "Integer56"},      TypeName{0x15, "Integer64"},     TypeName{0x16, "Unsigned24"},
    TypeName{0x18, "Unsigned40"},     TypeName{0x19, "Unsigned48"},    TypeName{0x1A, "Unsigned56"},
    TypeName{0x1B, "Unsigned64"},
};

const TypeName* name_of_type(const SheetEntry& entry) {
  if (entry.type == nullptr) return nullptr;
  const auto* const found = std::ranges::find(kTypes, entry.type->number, &TypeName::number);
  return found == kTypes.end() ? nullptr : found;
}

/// A literal of std::int64_t; the smallest one has no literal of its own.
std::string literal(std::uint64_t bits) {
  const auto value = static_cast<std::int64_t>(bits);
  if (value == std::numeric_limits<std::int64_t>::min()) return "std::numeric_limits<std::int64_t>::min()";
  return fmt::format("{}", value);
}

/// A number in the form of canopen::EntryDescription: two's complement, or the bit pattern of a REAL.
std::string number(const Value& value, const DataTypeRow& type) {
  if (value.kind == ValueKind::Real)
    return literal(type.bits == 32 ? std::bit_cast<std::uint32_t>(static_cast<float>(value.real))
                                   : std::bit_cast<std::uint64_t>(value.real));
  return literal(value.integer.negative ? ~value.integer.magnitude + 1 : value.integer.magnitude);
}

/// A string literal of any bytes: what is not plain is escaped in octal, which cannot swallow what follows.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\' || c == '?') {
      (result += '\\') += c;
    } else if (byte < 0x20 || byte > 0x7E) {
      result += fmt::format("\\{:03o}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

/// The bytes that pairs of hexadecimal digits stand for; the pairs are known to be right.
std::string bytes_of(std::string_view pairs) {
  std::string bytes;
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
  for (std::size_t n = 0; n + 1 < pairs.size();) {
    if (pairs[n] == ' ') {
      ++n;
      continue;
    }
    bytes += static_cast<char>(digit(pairs[n]) << 4 | digit(pairs[n + 1]));
    n += 2;
  }
  return bytes;
}

class SourceLine {
 public:
  SourceLine(std::string& text, std::uint16_t index, const SheetEntry& entry) : text_{text}, entry_{entry} {
    fmt::format_to(out(), "      {{.index = 0x{:04X}", index);
    if (entry.sub_index != 0) add("sub_index", fmt::format("{}", entry.sub_index));
  }

  void add(std::string_view member, std::string_view value) { fmt::format_to(out(), ", .{} = {}", member, value); }

  void add_value() {
    const bool text = entry_.type->kind == ValueKind::Text || entry_.type->kind == ValueKind::Bytes;
    if (!text) return add_number();
    if (entry_.type->number == 0x0F) return;  // a DOMAIN has its data elsewhere
    const std::string content = !entry_.default_value                   ? std::string{}
                                : entry_.type->kind == ValueKind::Bytes ? bytes_of(entry_.default_value->text)
                                                                        : entry_.default_value->text;
    if (!content.empty()) add("text", fmt::format("std::string_view{{{}, {}}}", quoted(content), content.size()));
  }

  void add_name_and_capacity(const SourceOptions& options) {
    add("name", quoted(entry_.name));
    const auto access = entry_.access_or_default();
    const bool writable = access != canopen::Access::ReadOnly && access != canopen::Access::Constant;
    if (entry_.type->bits == 0 && entry_.type->number != 0x0F && writable)
      add("capacity", fmt::format("{}", std::max<std::size_t>(options.text_capacity, longest())));
  }

  void end() { text_ += "},\n"; }

 private:
  std::back_insert_iterator<std::string> out() { return std::back_inserter(text_); }

  [[nodiscard]] std::size_t longest() const {
    return entry_.default_value ? entry_.default_value->text.size() : 0;
  }

  void add_number() {
    const auto& initial = entry_.default_value;
    if (initial && number(*initial, *entry_.type) != "0") add("initial", number(*initial, *entry_.type));
    if (entry_.low && !entry_.low->node_relative) add("low", number(*entry_.low, *entry_.type));
    if (entry_.high && !entry_.high->node_relative) add("high", number(*entry_.high, *entry_.type));
  }

  std::string& text_;
  const SheetEntry& entry_;
};

void write_row(std::string& text, std::uint16_t index, const SheetEntry& entry, const SourceOptions& options) {
  SourceLine row{text, index, entry};
  row.add("type", name_of_type(entry)->enumerator);
  row.add("access", name_of(kAccesses, entry.access_or_default()).enumerator);
  if (entry.mappable.value_or(false)) row.add("pdo_mappable", "true");
  if (entry.default_value && entry.default_value->node_relative) row.add("node_relative", "true");
  if (find_cob_id(index, entry.sub_index) != nullptr) row.add("limit_check", "canopen::LimitCheck::Owner");
  row.add_value();
  row.add_name_and_capacity(options);
  row.end();
}

}  // namespace

std::string write_dictionary(const DataSheet& sheet, const SourceOptions& options, Findings& findings) {
  std::string text = fmt::format(R"(#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include <libcanopen/od/entry_description.hpp>

// clang-format off
/// The object dictionary of {}: one row an entry, in ascending order of index and sub-index.
inline constexpr auto {} = [] {{
  using enum canopen::DataType;
  using enum canopen::Access;
  return std::to_array<canopen::EntryDescription>({{
)",
                                 printable(options.origin), options.table);
  for (const auto& [index, object] : sheet.objects)
    for (const SheetEntry& entry : object.entries) {
      if (name_of_type(entry) != nullptr) {
        write_row(text, index, entry, options);
        continue;
      }
      findings.warning("data-type", entry.section->place("DataType"), "a simple data type of CiA 301",
                       entry.data_type.text());
    }
  return text + "  });\n}();\n// clang-format on\n";
}

}  // namespace eds
