#include <map>

#include <fmt/format.h>

#include "gateway/base/error.hpp"
#include "gateway/openapi/operations.hpp"
#include "gateway/openapi/own_schemas.hpp"
#include "gateway/openapi/writers.hpp"
#include "gateway/routes/routes.hpp"

namespace gateway {
namespace {

constexpr int kIndent = 1;
constexpr std::string_view kDescription =
    "The units of all axisd of a machine. Reading needs nothing; what is not GET needs the token of the "
    "server.\n\n"
    "A stream of events has `event` (schema `event`), `units` (the names that there are now), `gap` (what came "
    "since "
    "Last-Event-ID was not kept) and `cut-off` (this viewer reads too slowly, and the stream ends). A stream of "
    "samples "
    "has `signals` (what was asked for), `sample` (schema `sample`), or with batch_ms `samples` (schema "
    "`samples`), "
    "`ended` and `cut-off`; one of frames has `unit`, `frames` (schema `frames`), `ended` and `cut-off`. Comments "
    "come every 15 s.";

std::string number_of(Status status) {
  return std::to_string(static_cast<unsigned>(status));
}

/// The codes of each status, and what they mean.
std::map<std::string, std::map<std::string, std::string>> codes_by_status() {
  std::map<std::string, std::map<std::string, std::string>> codes;
  for (const ErrorRow& row : kRefusals) codes[number_of(row.status)][std::string{row.code}] = row.meaning;
  for (const ControlStatus& row : kControlStatus) {
    const control::ErrorName& name = control::kErrorNames[static_cast<std::size_t>(row.code)];
    codes[number_of(row.status)][std::string{name.name}] = name.meaning;
  }
  return codes;
}

OrderedJson head(std::string_view version) {
  return {
      {"openapi", "3.1.0"},
      {"info",
       {{"title", "axisd-http"},
        {"version", version},
        {"description", kDescription},
        {"license", {{"name", "Apache License 2.0"}, {"identifier", "Apache-2.0"}}}}},
      {"servers", {{{"url", "http://127.0.0.1:8402"}, {"description", "as it is started without options"}}}},
      {"tags",
       {{{"name", "gateway"}, {"description", "what concerns all units"}},
        {{"name", "unit"}, {"description", "one unit: bus and node are the two parts of its name, vcan0/5"}}}}};
}

}  // namespace

OrderedJson write_error_schema() {
  OrderedJson codes = OrderedJson::array();
  for (const auto& [status, rows] : codes_by_status())
    for (const auto& [code, meaning] : rows) codes.push_back(code);
  return {
      {"type", "object"},
      {"description", "why the request was not carried out"},
      {"properties",
       {{"error",
         {{"type", "object"},
          {"properties",
           {{"code", {{"enum", std::move(codes)}}},
            {"message", {{"type", "string"}, {"description", "one line: what was wrong, and what was expected"}}},
            {"limits",
             {{"type", "object"},
              {"description", "what holds, of a number that is out of range"},
              {"properties", {{"low", {{"type", "number"}}}, {"high", {{"type", "number"}}}}}}}}},
          {"required", {"code", "message"}}}}}},
      {"required", {"error"}}};
}

OrderedJson write_error_responses() {
  OrderedJson responses = OrderedJson::object();
  for (const auto& [status, rows] : codes_by_status()) {
    if (status == number_of(Status::MethodNotAllowed)) continue;  // of what is no operation
    std::string description;
    for (const auto& [code, meaning] : rows)
      description += fmt::format("{}`{}`: {}", description.empty() ? "" : "; ", code, meaning);
    responses[status] = {
        {"description", std::move(description)},
        {"content", {{"application/json", {{"schema", {{"$ref", "#/components/schemas/error"}}}}}}}};
  }
  return responses;
}

std::string write_document(const nlohmann::json& schema, std::string_view version) {
  OperationWriter writer{schema};
  OrderedJson document = head(version);
  for (const Route& route : routes()) {
    std::string verb{route.verb};
    for (char& c : verb) c = static_cast<char>(c - 'A' + 'a');
    document["paths"][std::string{route.path}][verb] = writer.write(route);
  }
  OrderedJson schemas = writer.schemas();
  schemas["units"] = units_schema(schema.at("$defs").at("result.units"));
  schemas["server"] = server_schema();
  schemas["overview"] = overview_schema(schema.at("$defs").at("result.status"));
  schemas["error"] = write_error_schema();
  document["components"]["schemas"] = std::move(schemas);
  document["components"]["responses"] = write_error_responses();
  document["components"]["securitySchemes"]["token"] = {
      {"type", "http"},
      {"scheme", "bearer"},
      {"description", "the token that the server has made at its first start"}};
  return document.dump(kIndent) + '\n';
}

}  // namespace gateway
