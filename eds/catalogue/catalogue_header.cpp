#include "eds/catalogue/catalogue_header.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "eds/catalogue/json_fields.hpp"

namespace eds {
namespace {

constexpr std::array<std::string_view, 14> kHeaderKeys{
    "notes",      "device",      "page_title",   "file_version", "file_revision", "created_time", "created_date",
    "created_by", "vendor_name", "product_name", "order_code",   "lss_supported", "dummies",      "comments"};
constexpr std::array<std::string_view, 4> kFileKeys{"name", "content", "axes", "description"};
constexpr std::array<std::string_view, 3> kOffsetKeys{"first", "last", "offset"};
constexpr std::int64_t kHighestVersion = 255;

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

std::vector<std::uint16_t> read_dummies(const JsonFields& fields) {
  std::vector<std::uint16_t> dummies;
  for (const std::string& text : fields.texts("dummies")) {
    const auto type = parse_hexadecimal(text, 4);
    const bool known = type && *type >= kFirstDummy && *type <= kLastDummy;
    if (!known || (!dummies.empty() && *type <= dummies.back()))
      fields.fail("dummies", fmt::format("data types {:04X} to {:04X}, ascending", kFirstDummy, kLastDummy));
    dummies.push_back(static_cast<std::uint16_t>(*type));
  }
  return dummies;
}

EdsFile read_file_row(const JsonFields& fields) {
  EdsFile file{.name = fields.text("name"),
               .content = fields.word("content", kFileContents),
               .description = fields.text("description")};
  if (!file.name.ends_with(".eds")) fields.fail("name", "a file name that ends with .eds");
  const bool counts = file.content == FileContent::Axes;
  if (counts) file.axes = static_cast<unsigned>(fields.integer("axes", kMostAxes));
  if (counts != fields.has("axes") || (counts && file.axes == 0))
    fields.fail("axes", fmt::format("1 to {} for the content axes, nothing for the others", kMostAxes));
  return file;
}

AxisOffset read_offset_row(const JsonFields& fields) {
  const AxisOffset row{.first = fields.hexadecimal("first"),
                       .last = fields.hexadecimal("last"),
                       .offset = fields.hexadecimal("offset")};
  if (row.last < row.first) fields.fail("last", "at least \"first\"");
  if (row.last - row.first >= row.offset) fields.fail("offset", "more than the range is long");
  if (row.last + (kMostAxes - 1) * row.offset > 0xFFFF) fields.fail("offset", "room below FFFF for every axis");
  return row;
}

}  // namespace

Header read_header(const nlohmann::json& json) {
  const JsonFields fields{json, "header", kHeaderKeys};
  if (fields.has("notes")) static_cast<void>(fields.texts("notes"));
  return {.device = fields.text("device"),
          .page_title = fields.text("page_title"),
          .file_version = fields.integer("file_version", kHighestVersion),
          .file_revision = fields.integer("file_revision", kHighestVersion),
          .created_time = text_like(fields, "created_time", "dd:ddAM", "a time as 10:00AM"),
          .created_date = text_like(fields, "created_date", "dd-dd-dddd", "a date as 12-31-2026"),
          .created_by = fields.text("created_by"),
          .vendor_name = fields.text("vendor_name"),
          .product_name = fields.text("product_name"),
          .order_code = fields.text("order_code"),
          .lss_supported = fields.boolean("lss_supported"),
          .dummies = read_dummies(fields),
          .comments = fields.texts("comments")};
}

std::vector<EdsFile> read_files(const nlohmann::json& json) {
  std::vector<EdsFile> files;
  for (const nlohmann::json& item : json) {
    const JsonFields fields{item, fmt::format("file {}", files.size() + 1), kFileKeys};
    EdsFile file = read_file_row(fields);
    if (std::ranges::find(files, file.name, &EdsFile::name) != files.end()) fields.fail("name", "every name once");
    files.push_back(std::move(file));
  }
  return files;
}

std::vector<AxisOffset> read_axis_offsets(const nlohmann::json& json) {
  std::vector<AxisOffset> offsets;
  for (const nlohmann::json& item : json) {
    const JsonFields fields{item, fmt::format("axis offset {}", offsets.size() + 1), kOffsetKeys};
    const AxisOffset row = read_offset_row(fields);
    if (!offsets.empty() && offsets.back().last >= row.first) fields.fail("first", "ranges in ascending order");
    offsets.push_back(row);
  }
  return offsets;
}

}  // namespace eds
