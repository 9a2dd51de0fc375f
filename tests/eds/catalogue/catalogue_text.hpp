#pragma once

#include <initializer_list>
#include <string>

#include "eds/catalogue/catalogue.hpp"

/// Builders of catalogues, valid and broken.
namespace eds {

/// A header.
inline const std::string kHeader =
    R"({"file_version": 1, "file_revision": 0, "created_time": "10:00AM", "created_date": "12-31-2026",
  "created_by": "b", "vendor_name": "v", "product_name": "p", "order_code": "o", "lss_supported": false,
  "dummies": [], "device": "the unit", "page_title": "Objects", "comments": ["c"]})";

/// What every catalogue must have; five rows.
inline const std::string kMandatory = R"(
  {"index": "1000", "sub": "00", "object": "VAR", "type": "UNSIGNED32", "access": "ro", "pdo": false, "value": "0", "scope": "unit", "name": "Type", "does": "d"},
  {"index": "1001", "sub": "00", "object": "VAR", "type": "UNSIGNED8", "access": "ro", "pdo": false, "value": "0", "scope": "unit", "name": "Error", "does": "d"},
  {"index": "1018", "object": "RECORD", "scope": "unit", "name": "Identity", "does": "d"},
  {"index": "1018", "sub": "00", "object": "VAR", "type": "UNSIGNED8", "access": "ro", "pdo": false, "default": "3", "scope": "unit", "name": "n"},
  {"index": "1018", "sub": "01-03", "object": "VAR", "type": "UNSIGNED32", "access": "ro", "pdo": false, "value": "0", "scope": "unit", "name": "Id"})";

/// One EDS file.
inline const std::string kFiles = R"({"name": "a.eds", "content": "axes", "axes": 1, "description": "d"})";
/// Offsets for PDO mappings and profile objects.
inline const std::string kOffsets = R"({"first": "1600", "last": "163F", "offset": "0040"},
  {"first": "1A00", "last": "1A3F", "offset": "0040"}, {"first": "5F00", "last": "67FF", "offset": "0900"})";

/// A catalogue of these rows of its lists.
inline std::string whole(const std::string& files, const std::string& offsets, const std::string& objects,
                         const std::string& parameters) {
  return R"({"header": )" + kHeader + R"(, "files": [)" + files + R"(], "axis_offsets": [)" + offsets +
         R"(], "objects": [)" + objects + R"(], "parameters": [)" + parameters + "]}";
}
/// A catalogue with the mandatory rows and @p more.
inline std::string catalogue(const std::string& more, const std::string& parameters = "") {
  return whole(kFiles, kOffsets, kMandatory + (more.empty() ? "" : ",") + more, parameters);
}

/// A row whose fields after the index are written by the test.
inline std::string row(const std::string& index, const std::string& fields) {
  return R"({"index": ")" + index + R"(", "scope": "axis", "name": "N")" + fields + "}";
}
/// The row of the variable 6000h.
inline std::string variable(const std::string& fields, const std::string& type = "UNSIGNED8",
                            const std::string& access = "rw") {
  return row("6000", R"(, "sub": "00", "object": "VAR", "type": ")" + type + R"(", "access": ")" + access +
                         R"(", "does": "d")" + fields);
}
/// The row of entries of an array or record.
inline std::string sub(const std::string& index, const std::string& subs, const std::string& type,
                       const std::string& value, const std::string& access = "ro") {
  return row(index, R"(, "sub": ")" + subs + R"(", "object": "VAR", "type": ")" + type + R"(", "access": ")" +
                        access + R"(", "pdo": false, "default": ")" + value + R"(")");
}
/// The row that opens an array or record.
inline std::string head(const std::string& index, const std::string& code) {
  return row(index, R"(, "does": "d", "object": ")" + code + R"(")");
}

/// Several rows.
inline std::string rows(std::initializer_list<std::string> list) {
  std::string text;
  for (const std::string& item : list) text.append(text.empty() ? "" : ",").append(item);
  return text;
}

/// What the catalogue @p text is refused with, or "accepted".
inline std::string message_of(const std::string& text) {
  try {
    static_cast<void>(parse_catalogue(text));
    return "accepted";
  } catch (const CatalogueError& error) {
    return error.what();
  }
}

}  // namespace eds
