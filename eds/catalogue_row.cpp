#include "eds/catalogue_row.hpp"

#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "eds/json_fields.hpp"

namespace eds {
namespace {

constexpr std::array<std::string_view, 14> kVariableKeys{"index",  "sub",       "object", "type", "access",
                                                         "pdo",    "default",   "value",  "low",  "high",
                                                         "limits", "obj_flags", "scope",  "name"};
constexpr std::array<std::string_view, 4> kHeadKeys{"index", "object", "scope", "name"};
constexpr std::int64_t kHighestFlags =
    3;  // CiA 306 defines bit 0 (refuse write on download) and bit 1 (refuse read on scan)

std::optional<std::uint32_t> hexadecimal(std::string_view text, std::size_t digits) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, 16);
  if (text.size() != digits || error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

/// "row 3 (6040:00)", with what there is of index and sub-index.
std::string place_of(const nlohmann::json& json, std::size_t number) {
  const auto word = [&json](const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
  };
  const std::string index = word("index"), sub = word("sub");
  if (index.empty()) return fmt::format("row {}", number);
  return fmt::format("row {} ({}{}{})", number, index, sub.empty() ? "" : ":", sub);
}

std::uint16_t read_index(const JsonFields& fields) {
  const auto index = hexadecimal(fields.text("index"), 4);
  if (!index || *index < 0x1000) fields.fail("index", "four hexadecimal digits, 1000 to FFFF");
  return static_cast<std::uint16_t>(*index);
}

std::pair<std::uint8_t, std::uint8_t> read_sub(const JsonFields& fields) {
  const std::string text = fields.text("sub");
  const std::size_t dash = text.find('-');
  const auto first = hexadecimal(std::string_view{text}.substr(0, dash), 2);
  const auto last = dash == std::string::npos ? first : hexadecimal(std::string_view{text}.substr(dash + 1), 2);
  if (!first || !last || *first > *last || *last > 0xFE)
    fields.fail("sub", "two hexadecimal digits, 00 to FE, or a range as 02-52");
  return {static_cast<std::uint8_t>(*first), static_cast<std::uint8_t>(*last)};
}

Number read_number(const JsonFields& fields, std::string_view key, const Range& range) {
  const std::string expected = fmt::format("a number as text, {} to {}", range.low, range.high);
  if (!fields.has(key)) fields.fail(key, expected);
  std::optional<Number> number = parse_number(fields.text(key));
  if (!number || !within(*number, range)) fields.fail(key, expected);
  return *std::move(number);
}

void read_initial(const JsonFields& fields, Entry& entry) {
  entry.default_stated = fields.has("default");
  if (entry.default_stated && fields.has("value")) fields.fail("value", "nothing beside \"default\"");
  const std::string_view key = entry.default_stated ? "default" : "value";
  const auto range = range_of(entry.type);
  entry.initial = range ? read_number(fields, key, *range) : Number{.text = fields.text(key)};
}

void read_limit(const JsonFields& fields, std::string_view key, const Entry& entry, std::optional<Number>& limit) {
  if (!fields.has(key)) return;
  const auto range = range_of(entry.type);
  if (!range) fields.fail(key, "no limit for a string");
  limit = read_number(fields, key, *range);
  // The dictionary compares with fixed numbers, so only what nobody writes may have a limit that moves.
  const bool written = entry.access != canopen::Access::ReadOnly && entry.access != canopen::Access::Constant;
  if (limit->node_relative && written) fields.fail(key, "a limit without $NODEID in a writable entry");
}

void read_limits(const JsonFields& fields, Entry& entry) {
  read_limit(fields, "low", entry, entry.low);
  read_limit(fields, "high", entry, entry.high);
  if (entry.low && entry.high && !ordered(*entry.low, *entry.high)) fields.fail("low", "at most \"high\"");
  const std::string_view key = entry.default_stated ? "default" : "value";
  if (entry.low && !ordered(*entry.low, entry.initial)) fields.fail(key, "at least \"low\"");
  if (entry.high && !ordered(entry.initial, *entry.high)) fields.fail(key, "at most \"high\"");
  if (!fields.has("limits")) return;
  entry.limit_check = fields.word("limits", kLimitChecks);
  if (!entry.low && !entry.high) fields.fail("limits", R"("low" or "high" beside it)");
}

/// CiA 306: a mappable entry is short enough for a PDO and says the direction by its access.
void check_mapping(const JsonFields& fields, const Entry& entry) {
  if (!entry.pdo_mappable) return;
  if (!range_of(entry.type)) fields.fail("pdo", "false for a string");
  if (entry.access == canopen::Access::ReadWrite || entry.access == canopen::Access::Constant)
    fields.fail("access", "ro, rwr, rww or wo for a mappable entry");
}

Entry read_entry(const JsonFields& fields) {
  Entry entry;
  entry.type = fields.word("type", kDataTypes);
  entry.access = fields.word("access", kAccesses);
  entry.pdo_mappable = fields.boolean("pdo");
  entry.name = fields.text("name");
  check_mapping(fields, entry);
  read_initial(fields, entry);
  read_limits(fields, entry);
  if (fields.has("obj_flags"))
    entry.object_flags = static_cast<std::uint32_t>(fields.integer("obj_flags", kHighestFlags));
  return entry;
}

}  // namespace

Row parse_row(const nlohmann::json& json, std::size_t number) {
  Row row;
  row.place = place_of(json, number);
  row.code = JsonFields{json, row.place, kVariableKeys}.word("object", kObjectCodes);
  const bool variable = row.code == ObjectCode::Variable;
  const JsonFields fields{json, row.place,
                          variable ? std::span<const std::string_view>{kVariableKeys} : kHeadKeys};
  row.index = read_index(fields);
  row.scope = fields.word("scope", kScopes);
  row.name = fields.text("name");
  if (!variable) return row;
  const auto [first, last] = read_sub(fields);
  row.entry = read_entry(fields);
  row.entry->sub_index = first;
  row.last_sub = last;
  return row;
}

}  // namespace eds
