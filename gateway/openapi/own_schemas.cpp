#include "gateway/openapi/own_schemas.hpp"

#include <string>

#include <fmt/format.h>

#include "gateway/base/overview_keys.hpp"

namespace gateway {
namespace {

constexpr std::string_view kStatus = "#/components/schemas/result.status/properties";

/// Adds @p key, which is what it is in the object at @p place; it is required if it is so in @p object.
void add_same(OrderedJson& schema, const nlohmann::json& object, std::string_view place, std::string_view key) {
  const std::string name{key};
  if (!object.at("properties").contains(name)) return;
  schema["properties"][name] = {{"$ref", fmt::format("{}/{}", place, key)}};
  for (const auto& required : object.value("required", nlohmann::json::array()))
    if (required == key) schema["required"].push_back(name);
}

/// The members @p keys of @p object, which is at @p place.
template <class Keys>
OrderedJson part_of(const nlohmann::json& object, std::string_view place, const Keys& keys) {
  OrderedJson schema{
      {"type", "object"}, {"properties", OrderedJson::object()}, {"required", OrderedJson::array()}};
  for (const std::string_view key : keys)
    if (!key.empty()) add_same(schema, object, place, key);
  return schema;
}

}  // namespace

OrderedJson units_schema(const nlohmann::json& units) {
  const auto same = [&units](const char* key) {
    constexpr std::string_view kDefinitions = "#/$defs/";
    std::string text = units.at("properties").at(key).dump();
    for (std::size_t at = text.find(kDefinitions); at != std::string::npos; at = text.find(kDefinitions))
      text.replace(at, kDefinitions.size(), "#/components/schemas/");
    return OrderedJson::parse(text);
  };
  OrderedJson daemon{
      {"socket", {{"type", "string"}, {"description", "path of its control socket, or the URL of the farm"}}},
      {"units", {{"type", "array"}, {"items", {{"type", "string"}}}, {"description", "their names"}}}};
  OrderedJson required = OrderedJson::array({"socket", "units"});
  for (const char* const key : {"clients", "refused_clients", "cut_off_clients", "lost_events"}) {
    daemon[key] = same(key);
    required.push_back(key);
  }
  OrderedJson daemons{
      {"type", "array"},
      {"items", {{"type", "object"}, {"properties", std::move(daemon)}, {"required", std::move(required)}}}};
  return {{"type", "object"},
          {"properties", {{"units", same("units")}, {"daemons", std::move(daemons)}}},
          {"required", {"units", "daemons"}}};
}

OrderedJson server_schema() {
  return {{"type", "object"},
          {"properties",
           {{"program", {{"const", "axisd-http"}}},
            {"version", {{"type", "string"}}},
            {"read_only", {{"type", "boolean"}, {"description", "whatever changes a unit is refused"}}},
            {"token",
             {{"enum", {"none", "missing", "wrong", "right"}},
              {"description", "of the header Authorization of the request; `none`: the server has no token"}}}}},
          {"required", {"program", "version", "read_only", "token"}}};
}

OrderedJson overview_schema(const nlohmann::json& status) {
  OrderedJson unit{
      {"type", "object"},
      {"properties",
       {{"unit", {{"type", "string"}}},
        {"on", {{"type", "boolean"}, {"description", "it is switched on, and its daemon has answered"}}},
        {"error", {{"type", "string"}, {"description", "why nothing is known of it; absent if it is off"}}},
        {"host", {{"type", "string"}, {"description", "of a farm: where it is"}}}}},
      {"required", {"unit", "on"}}};
  const OrderedJson plain = part_of(status, kStatus, kOverviewKeys);
  unit["properties"].update(plain["properties"]);
  for (const OverviewPart& part : kOverviewParts) {
    const std::string key{part.key};
    unit["properties"][key] =
        part_of(status.at("properties").at(key), fmt::format("{}/{}/properties", kStatus, part.key), part.members);
  }
  const nlohmann::json& axis = status.at("properties").at("axes").at("items");
  unit["properties"]["axes"] = {
      {"type", "array"},
      {"items", part_of(axis, fmt::format("{}/axes/items/properties", kStatus), kOverviewAxis)}};
  return {{"type", "object"},
          {"properties", {{"units", {{"type", "array"}, {"items", std::move(unit)}}}}},
          {"required", {"units"}}};
}

}  // namespace gateway
