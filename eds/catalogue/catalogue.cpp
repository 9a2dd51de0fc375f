#include "eds/catalogue/catalogue.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "eds/catalogue/axes.hpp"
#include "eds/catalogue/catalogue_check.hpp"
#include "eds/catalogue/catalogue_header.hpp"
#include "eds/catalogue/catalogue_row.hpp"
#include "eds/catalogue/json_fields.hpp"

namespace eds {
namespace {

constexpr std::array<std::string_view, 5> kTopKeys{"header", "files", "axis_offsets", "objects", "parameters"};

/// True when @p row goes on with the object that was opened last. Drive objects of one index differ.
bool continues(const std::vector<Object>& objects, const CatalogueRow& row, RowKind kind) {
  if (objects.empty() || objects.back().index != row.index) return false;
  return kind == RowKind::Object || objects.back().scope == row.scope;
}

void open_object(std::vector<Object>& objects, const CatalogueRow& row) {
  if (!objects.empty() && objects.back().index > row.index)
    throw CatalogueError{row.place + ": field \"index\": expected rows in ascending order"};
  objects.push_back({.index = row.index,
                     .code = row.code,
                     .scope = row.scope,
                     .name = row.name,
                     .does = row.does.value_or(""),
                     .entries = {}});
}

void check_continuation(const Object& object, const CatalogueRow& row) {
  if (!row.entry)
    throw CatalogueError{row.place + ": field \"object\": expected the row before those of its sub-indices, once"};
  if (object.scope != row.scope)
    throw CatalogueError{row.place + ": field \"scope\": expected that of the object's first row"};
  if (row.does) throw CatalogueError{row.place + ": field \"does\": expected it in the object's first row only"};
}

/// Adds the entries of @p row to the object it belongs to, or opens an object.
void add_row(std::vector<Object>& objects, const CatalogueRow& row, RowKind kind) {
  if (continues(objects, row, kind)) {
    check_continuation(objects.back(), row);
  } else {
    open_object(objects, row);
  }
  if (!row.entry) return;
  for (unsigned sub = row.entry->sub_index; sub <= row.last_sub; ++sub) {
    objects.back().entries.push_back(*row.entry);
    objects.back().entries.back().sub_index = static_cast<std::uint8_t>(sub);
  }
}

using Seen = std::set<std::tuple<unsigned, unsigned, Scope>>;

/// Refuses an entry that stands in two rows of a list, wherever they are.
void check_unique(Seen& seen, const CatalogueRow& row, RowKind kind) {
  if (!row.entry) return;
  const Scope scope = kind == RowKind::Parameter ? row.scope : Scope::Unit;
  for (unsigned sub = row.entry->sub_index; sub <= row.last_sub; ++sub)
    if (!seen.emplace(row.index, sub, scope).second)
      throw CatalogueError{
          fmt::format("{}: field \"sub\": expected {:04X}:{:02X} in one row only", row.place, row.index, sub)};
}

std::vector<Object> read_rows(const nlohmann::json& list, RowKind kind) {
  std::vector<Object> objects;
  Seen seen;
  std::size_t number = 0;
  for (const nlohmann::json& item : list) {
    const CatalogueRow row = parse_row(item, ++number, kind);
    check_unique(seen, row, kind);
    add_row(objects, row, kind);
  }
  return objects;
}

}  // namespace

Catalogue parse_catalogue(std::string_view json) {
  const nlohmann::json root = parse_json(json);
  const JsonFields fields{root, "catalogue", kTopKeys};
  if (!fields.has("header")) fields.fail("header", "an object");
  for (const std::string_view list : {"files", "axis_offsets", "objects", "parameters"})
    if (!fields.has(list) || !root[std::string{list}].is_array()) fields.fail(list, "a list of rows");
  Catalogue catalogue{.header = read_header(root["header"]),
                      .files = read_files(root["files"]),
                      .axis_offsets = read_axis_offsets(root["axis_offsets"]),
                      .objects = read_rows(root["objects"], RowKind::Object),
                      .parameters = read_rows(root["parameters"], RowKind::Parameter)};
  check_objects(catalogue);
  return catalogue;
}

void add_parameters(Catalogue& catalogue, std::string_view json) {
  const nlohmann::json rows = parse_json(json);
  if (!rows.is_array()) throw CatalogueError{"expected a list of parameter rows"};
  std::vector<Object> all = catalogue.parameters;
  for (Object& object : read_rows(rows, RowKind::Parameter))
    if (!lists_parameter(catalogue, object.scope, object.index)) all.push_back(std::move(object));
  std::ranges::stable_sort(all, {}, &Object::index);
  catalogue.parameters = std::move(all);
  check_objects(catalogue);
}

const Entry* find_entry(std::span<const Object> objects, std::uint16_t index, std::uint8_t sub_index) noexcept {
  const auto object = std::ranges::find(objects, index, &Object::index);
  if (object == objects.end()) return nullptr;
  const auto entry = std::ranges::find(object->entries, sub_index, &Entry::sub_index);
  return entry == object->entries.end() ? nullptr : &*entry;
}

}  // namespace eds
