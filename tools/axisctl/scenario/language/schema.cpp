#include "tools/axisctl/scenario/language/schema.hpp"

#include <fmt/format.h>

#include "injection/json/fault_json.hpp"
#include "injection/json/when_rows.hpp"
#include "tools/axisctl/scenario/language/fault_kinds.hpp"
#include "tools/axisctl/scenario/language/forms.hpp"

namespace scenario {
namespace {

using Json = nlohmann::ordered_json;

Json reference(const char* name) {
  return {{"$ref", std::string{"#/$defs/"} + name}};
}
Json list_of(const char* name) {
  return {{"type", "array"}, {"maxItems", 1000}, {"items", reference(name)}};
}

Json value_of(const Key& key) {
  if (const FormRow* const row = row_of(key.form)) return row->schema(key);
  switch (key.form) {
    case Form::Fault:
      return reference("fault");
    case Form::Faults:
      return list_of("fault");
    case Form::Condition:
      return reference("condition");
    case Form::State:
      return reference("state");
    case Form::Bus:
      return reference("bus");
    case Form::Units:
      return list_of("unit");
    case Form::Programs:
      return list_of("program");
    default:
      return list_of("step");
  }
}

void add(Json& object, const Key& key) {
  Json value = value_of(key);
  std::string text{key.help};
  if (!key.absent.empty() && key.absent != kNothing) text += fmt::format("; without it: {}", key.absent);
  value["description"] = std::move(text);
  object["properties"][std::string{key.key}] = std::move(value);
  if (key.absent.empty()) object["required"].push_back(key.key);
}

Json object_of(std::span<const Key> keys) {
  Json object{{"type", "object"},
              {"properties", Json::object()},
              {"required", Json::array()},
              {"additionalProperties", false}};
  for (const Key& key : keys) add(object, key);
  return object;
}

/// An object of one of @p rows, with @p common keys.
Json alternatives_of(std::span<const Alternative> rows, std::span<const Key> common) {
  Json all = Json::array();
  for (const Alternative& row : rows) {
    Json object = object_of({&row.key, 1});
    for (const Key& key : row.beside) add(object, key);
    for (const Key& key : common) add(object, key);
    all.push_back(std::move(object));
  }
  return {{"oneOf", std::move(all)}};
}

/// Kinds and keys alone: the values of a fault have a reader of their own, which knows more than a schema can say.
Json fault_schema() {
  Json kinds = Json::array(), properties;
  properties["kind"] = {};
  for (const injection::Kind& kind : fault_kinds()) {
    kinds.push_back(kind.name);
    for (const injection::ArgumentUse& use : kind.arguments) {
      const injection::ArgumentRow& row = injection::row_of(use.argument);
      properties[std::string{row.key}] = {{"type", {"number", "string"}}, {"description", row.summary}};
    }
  }
  for (const injection::WhenRow& row : injection::when_rows())
    properties[std::string{row.key}] = {{"type", {"number", "string"}}, {"description", row.summary}};
  properties["kind"] = {{"enum", std::move(kinds)}, {"description", "what goes wrong"}};
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", {"kind"}},
          {"additionalProperties", false}};
}

}  // namespace

Json schema() {
  Json result{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "A scenario of axisctl run"}};
  result.update(object_of(scenario_keys()));
  Json& parts = result["$defs"];
  parts["bus"] = object_of(bus_keys());
  parts["unit"] = object_of(unit_keys());
  parts["program"] = object_of(program_keys());
  parts["step"] = alternatives_of(actions(), step_keys());
  parts["condition"] = alternatives_of(conditions(), {});
  parts["state"] = alternatives_of(conditions().subspan(1), {});
  parts["fault"] = fault_schema();
  return result;
}

}  // namespace scenario
