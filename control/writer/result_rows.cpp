#include "control/writer/result_rows.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace control {
namespace {

constexpr std::string_view kPrefix = "#/$defs/";

/// A schema without reference: what it refers to, with its own description if it has one.
struct Resolved {
  Json schema;
  std::string definition;  ///< what it referred to
};

/// Whether what a definition says is told once, and only referred to elsewhere.
bool has_table(const Json& definition) {
  constexpr std::size_t kManyChoices = 5;
  return is_object(definition) || (definition.contains("enum") && definition["enum"].size() > kManyChoices);
}

Resolved resolve(const ProtocolText& text, const Json& schema) {
  if (!schema.contains("$ref")) return {schema, ""};
  const auto& target = schema["$ref"].get_ref<const std::string&>();
  const std::string name = target.starts_with(kPrefix) ? target.substr(kPrefix.size()) : "";
  if (!text.definitions.contains(name)) throw std::runtime_error{target + ": expected one of the definitions"};
  Resolved found = resolve(text, text.definitions[name]);
  if (schema.contains("description")) found.schema["description"] = schema["description"];
  return {std::move(found.schema), found.definition.empty() ? name : found.definition};
}

std::string word_of(const Json& type) {
  if (type == "boolean") return "true or false";
  if (type == "string") return "text";
  return type.get<std::string>();
}

std::string type_of(const ProtocolText& text, const Json& schema) {
  const auto& [own, definition] = resolve(text, schema);
  if (is_object(own) && !definition.empty()) return fmt::format("[{}](#{})", definition, definition);
  if (own.contains("enum")) {
    std::string words;
    for (const Json& value : own["enum"])
      words += (words.empty() ? "`" : ", `") + (value.is_string() ? value.get<std::string>() : value.dump()) + '`';
    return words;
  }
  if (own.contains("const")) return "`" + own["const"].dump() + "`";
  if (own.contains("items")) return "list of " + type_of(text, own["items"]);
  if (!own.contains("type")) return "any";
  if (!own["type"].is_array()) return word_of(own["type"]);
  std::string words;
  for (const Json& type : own["type"]) words += (words.empty() ? "" : " or ") + word_of(type);
  return words;
}

void collect(const ProtocolText& text, const Json& schema, const std::string& key, std::vector<ResultRow>& rows) {
  const auto& [own, definition] = resolve(text, schema);
  const bool is_reference = !definition.empty() && has_table(own);
  const std::string meaning = is_reference && !schema.contains("description") ? "" : own.value("description", "");
  if (is_object(own) && (definition.empty() || key.empty())) {
    if (!meaning.empty() && !key.empty()) rows.push_back({key, "object", meaning});
    for (const auto& item : own["properties"].items())
      collect(text, item.value(), key.empty() ? item.key() : key + '.' + item.key(), rows);
    return;
  }
  const bool of_objects = own.contains("items") && is_object(own["items"]);
  if (!of_objects || !meaning.empty()) rows.push_back({key, of_objects ? "list" : type_of(text, schema), meaning});
  if (of_objects) {
    Json element = own["items"];
    element.erase("description");
    collect(text, element, key + "[]", rows);
  }
}

}  // namespace

bool is_object(const Json& schema) {
  return schema.is_object() && schema.contains("properties");
}

std::vector<ResultRow> rows_of(const ProtocolText& text, const Json& schema) {
  std::vector<ResultRow> rows;
  if (has_table(resolve(text, schema).schema)) collect(text, schema, "", rows);
  return rows;
}

}  // namespace control
