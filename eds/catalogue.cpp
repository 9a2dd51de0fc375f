#include "eds/catalogue.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "eds/catalogue_check.hpp"
#include "eds/catalogue_row.hpp"
#include "eds/json_fields.hpp"

namespace eds {
namespace {

constexpr std::array<std::string_view, 2> kTopKeys{"header", "objects"};
constexpr std::array<std::string_view, 12> kHeaderKeys{
    "notes",        "file_name",  "file_version", "file_revision", "description", "created_time",
    "created_date", "created_by", "vendor_name",  "product_name",  "order_code",  "comments"};

/// @p key has the form of @p pattern, where d stands for a digit, A for A or P, and the rest for itself.
std::string text_like(const JsonFields& fields, std::string_view key, std::string_view pattern,
                      std::string_view expected) {
  std::string text = fields.text(key);
  const auto fits = [](char c, char form) {
    if (form == 'd') return c >= '0' && c <= '9';
    return form == 'A' ? c == 'A' || c == 'P' : c == form;
  };
  if (!std::ranges::equal(text, pattern, fits)) fields.fail(key, expected);
  return text;
}

Header read_header(const nlohmann::json& json) {
  const JsonFields fields{json, "header", kHeaderKeys};
  if (fields.has("notes")) static_cast<void>(fields.texts("notes"));
  return {.file_name = fields.text("file_name"),
          .file_version = fields.integer("file_version", 255),
          .file_revision = fields.integer("file_revision", 255),
          .description = fields.text("description"),
          .created_time = text_like(fields, "created_time", "dd:ddAM", "a time as 10:00AM"),
          .created_date = text_like(fields, "created_date", "dd-dd-dddd", "a date as 12-31-2026"),
          .created_by = fields.text("created_by"),
          .vendor_name = fields.text("vendor_name"),
          .product_name = fields.text("product_name"),
          .order_code = fields.text("order_code"),
          .comments = fields.texts("comments")};
}

/// Adds the entries of @p row to the object it belongs to, or opens an object.
void add_row(std::vector<Object>& objects, const Row& row) {
  const bool same = !objects.empty() && objects.back().index == row.index;
  if (!same) {
    if (!objects.empty() && objects.back().index > row.index)
      throw CatalogueError{row.place + ": field \"index\": expected rows in ascending order"};
    objects.push_back({.index = row.index, .code = row.code, .scope = row.scope, .name = row.name, .entries = {}});
  } else if (!row.entry) {
    throw CatalogueError{row.place + ": field \"object\": expected the row before those of its sub-indices, once"};
  }
  if (!row.entry) return;
  Object& object = objects.back();
  if (object.scope != row.scope)
    throw CatalogueError{row.place + ": field \"scope\": expected that of the object's first row"};
  for (unsigned sub = row.entry->sub_index; sub <= row.last_sub; ++sub) {
    object.entries.push_back(*row.entry);
    object.entries.back().sub_index = static_cast<std::uint8_t>(sub);
  }
}

/// Refuses an entry that stands in two rows, wherever they are.
void check_unique(std::set<std::uint32_t>& seen, const Row& row) {
  if (!row.entry) return;
  for (unsigned sub = row.entry->sub_index; sub <= row.last_sub; ++sub)
    if (!seen.insert(std::uint32_t{row.index} << 8 | sub).second)
      throw CatalogueError{
          fmt::format("{}: field \"sub\": expected {:04X}:{:02X} in one row only", row.place, row.index, sub)};
}

}  // namespace

Catalogue parse_catalogue(std::string_view json) {
  const nlohmann::json root = parse_json(json);
  const JsonFields fields{root, "catalogue", kTopKeys};
  if (!fields.has("header")) fields.fail("header", "an object");
  if (!fields.has("objects") || !root["objects"].is_array()) fields.fail("objects", "a list of rows");
  Catalogue catalogue{.header = read_header(root["header"]), .objects = {}};
  std::set<std::uint32_t> seen;
  std::size_t number = 0;
  for (const nlohmann::json& item : root["objects"]) {
    const Row row = parse_row(item, ++number);
    check_unique(seen, row);
    add_row(catalogue.objects, row);
  }
  check_objects(catalogue);
  return catalogue;
}

const Entry* find_entry(const Catalogue& catalogue, std::uint16_t index, std::uint8_t sub_index) noexcept {
  const auto object = std::ranges::find(catalogue.objects, index, &Object::index);
  if (object == catalogue.objects.end()) return nullptr;
  const auto entry = std::ranges::find(object->entries, sub_index, &Entry::sub_index);
  return entry == object->entries.end() ? nullptr : &*entry;
}

}  // namespace eds
