#include "eds/catalogue/catalogue_row.hpp"

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "eds/catalogue/json_fields.hpp"

namespace eds {
namespace {

constexpr std::array<std::string_view, 20> kVariableKeys{
    "index",  "sub",          "object", "type", "access", "pdo",       "default", "value", "start", "other_axes",
    "vector", "several_axes", "low",    "high", "limits", "obj_flags", "unit",    "scope", "name",  "does"};
constexpr std::array<std::string_view, 5> kHeadKeys{"index", "object", "scope", "name", "does"};
constexpr std::int64_t kHighestFlags =
    3;  // CiA 306 defines bit 0 (refuse write on download) and bit 1 (refuse read on scan)

/// "row 3 (6040:00)", with what there is of index and sub-index.
std::string place_of(const nlohmann::json& json, std::size_t number, RowKind kind) {
  const std::string_view word_of_kind = kind == RowKind::Parameter ? "parameter row" : "row";
  const auto word = [&json](const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
  };
  const std::string index = word("index"), sub = word("sub");
  if (index.empty()) return fmt::format("{} {}", word_of_kind, number);
  return fmt::format("{} {} ({}{}{})", word_of_kind, number, index, sub.empty() ? "" : ":", sub);
}

std::uint16_t read_index(const JsonFields& fields) {
  const auto index = parse_hexadecimal(fields.text("index"), 4);
  if (!index || *index < 0x1000) fields.fail("index", "four hexadecimal digits, 1000 to FFFF");
  return static_cast<std::uint16_t>(*index);
}

std::pair<std::uint8_t, std::uint8_t> read_sub(const JsonFields& fields) {
  const std::string text = fields.text("sub");
  const std::size_t dash = text.find('-');
  const auto first = parse_hexadecimal(std::string_view{text}.substr(0, dash), 2);
  const auto last =
      dash == std::string::npos ? first : parse_hexadecimal(std::string_view{text}.substr(dash + 1), 2);
  if (!first || !last || *first > *last || *last > 0xFE)
    fields.fail("sub", "two hexadecimal digits, 00 to FE, or a range as 02-52");
  return {static_cast<std::uint8_t>(*first), static_cast<std::uint8_t>(*last)};
}

bool is_text(const Entry& entry) noexcept {
  return canopen::size_of(entry.type) == 0;
}

Number read_real(const JsonFields& fields, std::string_view key) {
  constexpr std::string_view kExpected = "a decimal number as text";
  if (!fields.has(key)) fields.fail(key, kExpected);
  std::optional<Number> number = parse_real(fields.text(key));
  if (!number) fields.fail(key, kExpected);
  return *std::move(number);
}

Number read_number(const JsonFields& fields, std::string_view key, canopen::DataType type) {
  const auto range = range_of(type);
  if (!range) return read_real(fields, key);
  const std::string expected = fmt::format("a number as text, {} to {}", range->low, range->high);
  if (!fields.has(key)) fields.fail(key, expected);
  std::optional<Number> number = parse_number(fields.text(key));
  if (!number || !within(*number, *range)) fields.fail(key, expected);
  return *std::move(number);
}

/// What no constant tells, begins as 0 or as an empty text until the device has it.
void read_start(const JsonFields& fields, Entry& entry) {
  if (entry.default_stated || fields.has("value")) fields.fail("start", "nothing beside \"default\" or \"value\"");
  entry.start = fields.text("start");
  if (!is_text(entry)) entry.initial.text = "0";
}

void read_initial(const JsonFields& fields, RowKind kind, Entry& entry) {
  entry.default_stated = fields.has("default");
  if (entry.default_stated && fields.has("value")) fields.fail("value", "nothing beside \"default\"");
  for (const std::string_view key : {"value", "start"})
    if (kind == RowKind::Parameter && fields.has(key)) fields.fail(key, "\"default\" or nothing for a parameter");
  if (kind == RowKind::Parameter && !entry.default_stated) return;
  if (fields.has("start")) return read_start(fields, entry);
  const std::string_view key = entry.default_stated ? "default" : "value";
  entry.initial = is_text(entry) ? Number{.text = fields.text(key)} : read_number(fields, key, entry.type);
}

/// The initial value of axes that are not as the catalogue gives them.
std::optional<Number> read_variant(const JsonFields& fields, std::string_view key, const Entry& entry) {
  if (!fields.has(key)) return std::nullopt;
  if (is_text(entry)) fields.fail(key, "no other value for a string");
  return read_number(fields, key, entry.type);
}

void read_limit(const JsonFields& fields, std::string_view key, const Entry& entry, std::optional<Number>& limit) {
  if (!fields.has(key)) return;
  if (is_text(entry)) fields.fail(key, "no limit for a string");
  limit = read_number(fields, key, entry.type);
  // The dictionary compares with fixed numbers, so only what nobody writes may have a limit that moves.
  const bool written = entry.access != canopen::Access::ReadOnly && entry.access != canopen::Access::Constant;
  if (limit->node_relative && written) fields.fail(key, "a limit without $NODEID in a writable entry");
}

std::string_view key_of_initial(const Entry& entry) noexcept {
  if (!entry.start.empty()) return "start";
  return entry.default_stated ? "default" : "value";
}

void read_limits(const JsonFields& fields, Entry& entry) {
  read_limit(fields, "low", entry, entry.low);
  read_limit(fields, "high", entry, entry.high);
  if (entry.low && entry.high && !ordered(*entry.low, *entry.high)) fields.fail("low", "at most \"high\"");
  const auto check = [&](std::string_view key, const Number& value) {
    if (entry.low && !ordered(*entry.low, value)) fields.fail(key, "at least \"low\"");
    if (entry.high && !ordered(value, *entry.high)) fields.fail(key, "at most \"high\"");
  };
  if (!entry.initial.text.empty()) check(key_of_initial(entry), entry.initial);
  if (entry.other_axes) check("other_axes", *entry.other_axes);
  if (entry.vector) check("vector", *entry.vector);
  if (entry.several_axes) check("several_axes", *entry.several_axes);
  if (!fields.has("limits")) return;
  entry.limit_check = fields.word("limits", kLimitChecks);
  if (!entry.low && !entry.high) fields.fail("limits", R"("low" or "high" beside it)");
}

/// CiA 306: a mappable entry is short enough for a PDO and says the direction by its access.
void check_mapping(const JsonFields& fields, const Entry& entry) {
  if (!entry.pdo_mappable) return;
  if (is_text(entry)) fields.fail("pdo", "false for a string");
  if (entry.access == canopen::Access::ReadWrite || entry.access == canopen::Access::Constant)
    fields.fail("access", "ro, rwr, rww or wo for a mappable entry");
}

Entry read_entry(const JsonFields& fields, RowKind kind) {
  Entry entry;
  entry.type = fields.word("type", kDataTypes);
  entry.access = fields.word("access", kAccesses);
  entry.pdo_mappable = fields.boolean("pdo");
  entry.name = fields.text("name");
  check_mapping(fields, entry);
  read_initial(fields, kind, entry);
  entry.other_axes = read_variant(fields, "other_axes", entry);
  entry.vector = read_variant(fields, "vector", entry);
  entry.several_axes = read_variant(fields, "several_axes", entry);
  if (fields.has("unit")) entry.unit = fields.text("unit");
  read_limits(fields, entry);
  if (fields.has("obj_flags"))
    entry.object_flags = static_cast<std::uint32_t>(fields.integer("obj_flags", kHighestFlags));
  return entry;
}

Scope read_scope(const JsonFields& fields, RowKind kind) {
  return kind == RowKind::Parameter ? fields.word("scope", kParameterScopes) : fields.word("scope", kObjectScopes);
}

}  // namespace

CatalogueRow parse_row(const nlohmann::json& json, std::size_t number, RowKind kind) {
  CatalogueRow row;
  row.place = place_of(json, number, kind);
  row.code = JsonFields{json, row.place, kVariableKeys}.word("object", kObjectCodes);
  const bool variable = row.code == ObjectCode::Variable;
  const JsonFields fields{json, row.place,
                          variable ? std::span<const std::string_view>{kVariableKeys} : kHeadKeys};
  row.index = read_index(fields);
  row.scope = read_scope(fields, kind);
  row.name = fields.text("name");
  if (fields.has("does")) row.does = fields.text("does");
  if (!variable) return row;
  const auto [first, last] = read_sub(fields);
  row.entry = read_entry(fields, kind);
  if (row.entry->other_axes && row.scope != Scope::Axis) fields.fail("other_axes", "it in the scope axis only");
  if (row.entry->several_axes && row.scope != Scope::Unit)
    fields.fail("several_axes", "it in the scope unit only");
  row.entry->sub_index = first;
  row.last_sub = last;
  return row;
}

}  // namespace eds
