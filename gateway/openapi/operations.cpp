#include "gateway/openapi/operations.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "gateway/base/content_type.hpp"
#include "gateway/base/error.hpp"
#include "gateway/base/percent.hpp"
#include "gateway/openapi/poll_schemas.hpp"
#include "gateway/routes/own_parameters.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::string_view kDefinitions = "#/$defs/";
constexpr std::string_view kSchemas = "#/components/schemas/";
constexpr int kHighestNode = 127;

/// The same with references to where they lead in an OpenAPI file; @p referred gets the names.
void lead_elsewhere(json& schema, std::set<std::string>& referred) {
  if (schema.is_object() && schema.contains("$ref")) {
    const std::string name = schema["$ref"].get<std::string>().substr(kDefinitions.size());
    referred.insert(name);
    schema["$ref"] = std::string{kSchemas} + name;
  }
  if (schema.is_structured())
    for (json& below : schema) lead_elsewhere(below, referred);
}

OrderedJson ordered(const json& value) {
  return OrderedJson::parse(value.dump());
}

OrderedJson path_parameter(std::string_view name, OrderedJson schema, std::string_view meaning) {
  return {
      {"name", name}, {"in", "path"}, {"required", true}, {"description", meaning}, {"schema", std::move(schema)}};
}

std::string lower(std::string_view text) {
  std::string result{text};
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

/// What stands in a URL for a list is one text with commas.
json as_list(json schema) {
  if (schema.contains("anyOf") && schema["anyOf"].back().value("type", "") == "array") {
    json list = schema["anyOf"].back();
    if (schema.contains("description")) list["description"] = schema["description"];
    return list;
  }
  return schema;
}

constexpr bool is_asked_of_daemon(Kind kind) noexcept {
  constexpr std::array kKinds{Kind::Call, Kind::Axis, Kind::Samples, Kind::Frames, Kind::Live, Kind::Eds};
  return std::ranges::find(kKinds, kind) != kKinds.end();
}

/// The statuses of errors that @p route can have.
std::vector<Status> statuses_of(const Route& route) {
  std::vector<Status> found{Status::BadRequest, Status::Forbidden, Status::MisdirectedRequest};
  if (route.is_write())
    found.insert(found.end(), {Status::Unauthorized, Status::ContentTooLarge, Status::UnsupportedMediaType});
  if (is_asked_of_daemon(route.kind))
    found.insert(found.end(),
                 {Status::NotFound, Status::Conflict, Status::UnprocessableContent, Status::TooManyRequests,
                  Status::NotImplemented, Status::BadGateway, Status::ServiceUnavailable, Status::GatewayTimeout});
  if (route.kind == Kind::Events) found.push_back(Status::TooManyRequests);
  if (route.kind == Kind::Asset) found.push_back(Status::NotFound);
  std::ranges::sort(found);
  return found;
}

OrderedJson text_schema() {
  return {{"type", "string"}};
}

/// What the files of the page are.
OrderedJson asset_types() {
  OrderedJson types = OrderedJson::object();
  for (const ContentType& row : kContentTypes)
    types[std::string{row.type.substr(0, row.type.find(';'))}] = {{"schema", OrderedJson::object()}};
  return types;
}

/// Server-sent events, whose data are of @p schema.
OrderedJson stream_of(OrderedJson schema) {
  return {
      {"text/event-stream",
       {{"schema",
         {{"type", "string"}, {"contentMediaType", "application/json"}, {"contentSchema", std::move(schema)}}}}}};
}

}  // namespace

OrderedJson OperationWriter::write(const Route& route) {
  OrderedJson operation;
  operation["operationId"] = identifier(route);
  operation["summary"] = summary_of(route);
  operation["tags"] =
      OrderedJson::array({route.path.find("{bus}") != std::string_view::npos ? "unit" : "gateway"});
  operation["security"] = OrderedJson::array();
  if (route.is_write()) operation["security"].push_back({{"token", OrderedJson::array()}});
  if (OrderedJson all = parameters(route); !all.empty()) operation["parameters"] = std::move(all);
  if (OrderedJson own = body(route); !own.is_null()) operation["requestBody"] = std::move(own);
  operation["responses"]["200"] = {{"description", "done"}, {"content", content(route)}};
  if (route.kind == Kind::Start || route.kind == Kind::Asset)
    operation["responses"]["304"] = {{"description", "the copy that If-None-Match names is still the one"}};
  for (const Status status : statuses_of(route)) {
    const std::string number = std::to_string(static_cast<unsigned>(status));
    operation["responses"][number] = {{"$ref", "#/components/responses/" + number}};
  }
  return operation;
}

std::string OperationWriter::identifier(const Route& route) {
  std::string name{route.method};
  if (name.empty() || route.kind == Kind::Axis)
    name = segments_of(route.path).at(segments_of(route.path).size() - 1);
  if (route.kind == Kind::Axis) name = "axis";
  if (route.kind == Kind::Asset) name = "asset";
  std::erase_if(name, [](char c) { return c == '{' || c == '}'; });
  if (name.empty()) name = "start";
  if (!identifiers_.insert(name).second) identifiers_.insert(name += '.' + lower(route.verb));
  return name;
}

json OperationWriter::schema_of(const Route& route, std::string_view key) const {
  const std::string name = fmt::format("request.{}", route.method);
  return definitions_.at(name).at("properties").at("params").at("properties").at(std::string{key});
}

OrderedJson OperationWriter::parameter(const Route& route, const control::Parameter& row) const {
  json schema = route.method.empty() ? own_schema(row) : as_list(schema_of(route, row.key));
  const std::string meaning = schema.value("description", "");
  schema.erase("description");
  if (row.key == "index" || schema.empty()) schema = {{"type", "string"}};
  const bool is_list = schema.value("type", json{}) == "array";
  if (source_of(route, row.key) == ArgumentSource::Path) {
    OrderedJson made = path_parameter(name_in_path(route, row.key), ordered(schema), meaning);
    if (is_list) made["style"] = "simple";
    return made;
  }
  OrderedJson made{{"name", row.key}, {"in", "query"}, {"required", row.absent.empty()}, {"description", meaning}};
  made["schema"] = ordered(schema);
  if (is_list) made["explode"] = false;
  return made;
}

OrderedJson OperationWriter::parameters(const Route& route) const {
  OrderedJson all = OrderedJson::array();
  if (has_placeholder(route.path, "bus")) {
    all.push_back(path_parameter("bus", text_schema(), "label of the bus: vcan0 of the unit vcan0/5"));
    all.push_back(path_parameter("node", {{"type", "integer"}, {"minimum", 0}, {"maximum", kHighestNode}},
                                 "address switch of the unit: 5 of vcan0/5"));
  }
  if (route.kind == Kind::Axis)
    all.push_back(path_parameter("axis", {{"type", "integer"}, {"minimum", 1}}, "axis of the unit, 1.."));
  if (route.kind == Kind::Asset) all.push_back(path_parameter("name", text_schema(), "name of the file"));
  if (route.kind == Kind::Events) {
    all.push_back({{"name", kUnitFilter},
                   {"in", "query"},
                   {"required", false},
                   {"description", "units whose events are told, all if not given: vcan0/5"},
                   {"schema", {{"type", "array"}, {"items", text_schema()}}},
                   {"explode", false}});
    all.push_back(
        {{"name", "Last-Event-ID"},
         {"in", "header"},
         {"required", false},
         {"description", "id of the last event before the connection was lost; what came since is not kept"},
         {"schema", text_schema()}});
  }
  for (const control::Parameter& row : parameters_of(route)) {
    const ArgumentSource source = source_of(route, row.key);
    if (source == ArgumentSource::Path || source == ArgumentSource::Query) all.push_back(parameter(route, row));
  }
  return all;
}

OrderedJson OperationWriter::body(const Route& route) const {
  OrderedJson properties = OrderedJson::object();
  OrderedJson required = OrderedJson::array();
  for (const control::Parameter& row : parameters_of(route)) {
    if (source_of(route, row.key) != ArgumentSource::Body) continue;
    properties[std::string{row.key}] = ordered(schema_of(route, row.key));
    if (row.absent.empty()) required.push_back(row.key);
  }
  if (properties.empty()) return nullptr;
  const bool is_needed = !required.empty();
  OrderedJson schema{{"type", "object"}, {"properties", std::move(properties)}};
  if (is_needed) schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  return {{"required", is_needed}, {"content", {{"application/json", {{"schema", std::move(schema)}}}}}};
}

OrderedJson OperationWriter::content(const Route& route) {
  switch (route.kind) {
    case Kind::Call:
      return {{"application/json", {{"schema", reference(fmt::format("result.{}", route.method))}}}};
    case Kind::Axis:
      referred_.insert("result.status");
      return {{"application/json",
               {{"schema", {{"$ref", "#/components/schemas/result.status/properties/axes/items"}}}}}};
    case Kind::Units:
      return {{"application/json", {{"schema", {{"$ref", "#/components/schemas/units"}}}}}};
    case Kind::Events:
      return stream_of(reference("event"));
    case Kind::Samples:
      return stream_of({{"anyOf", {reference("sample"), reference("samples")}}});
    case Kind::Frames:
      return stream_of(reference("frames"));
    case Kind::Recent:
      return {{"application/json", {{"schema", recent_schema(definition("event"))}}}};
    case Kind::Live:
      return {{"application/json", {{"schema", live_schema(reference("samples"), reference("frames"))}}}};
    case Kind::Metrics:
      return {{"text/plain", {{"schema", text_schema()}}}};
    case Kind::Document:
      return {{"application/json", {{"schema", {{"type", "object"}}}}}};
    case Kind::Server:
    case Kind::Overview:
      return {{"application/json",
               {{"schema",
                 {{"$ref", std::string{kSchemas} + (route.kind == Kind::Server ? "server" : "overview")}}}}}};
    case Kind::Eds:
      return {{"text/plain", {{"schema", text_schema()}}}};
    case Kind::Asset:
      return asset_types();
    case Kind::Start:
      break;
  }
  return {{"application/json", {{"schema", {{"type", "object"}}}}}, {"text/html", {{"schema", text_schema()}}}};
}

OrderedJson OperationWriter::reference(const std::string& definition) {
  referred_.insert(definition);
  return {{"$ref", std::string{kSchemas} + definition}};
}

OrderedJson OperationWriter::definition(const std::string& name) {
  json schema = definitions_.at(name);
  lead_elsewhere(schema, referred_);
  return ordered(schema);
}

OrderedJson OperationWriter::schemas() const {
  OrderedJson all = OrderedJson::object();
  std::set<std::string> left = referred_;
  std::set<std::string> done;
  while (!left.empty()) {
    const std::string name = *left.begin();
    left.erase(left.begin());
    if (!done.insert(name).second) continue;
    json schema = definitions_.at(name);
    lead_elsewhere(schema, left);
    all[name] = ordered(schema);
  }
  return all;
}

}  // namespace gateway
