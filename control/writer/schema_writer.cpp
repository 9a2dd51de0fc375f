#include <fmt/format.h>

#include "control/error.hpp"
#include "control/writer/writers.hpp"

namespace control {
namespace {

constexpr int kIndent = 2;

Json reference(std::string_view definition) {
  return {{"$ref", fmt::format("#/$defs/{}", definition)}};
}

/// What a request may have for @p parameter; limits that depend on the unit are the daemon's.
Json schema_of(const Parameter& parameter) {
  const Range& range = parameter.range;
  switch (parameter.form) {
    case Form::Axis:
      return {{"type", "integer"}, {"minimum", static_cast<int>(range.low)}};
    case Form::Place:
      return {{"anyOf", {{{"type", "integer"}, {"minimum", 0}}, {{"const", "infeed"}}}}};
    case Form::Integer:
    case Form::Fault:
    case Form::Terminal:
      return {{"type", "integer"},
              {"minimum", static_cast<std::int64_t>(range.low)},
              {"maximum", static_cast<std::int64_t>(range.high)}};
    case Form::Number:
      return {{"type", "number"}, {"minimum", range.low}, {"maximum", range.high}};
    case Form::Choice: {
      Json choices = Json::array();
      for (const std::string_view choice : parameter.choices) choices.push_back(std::string{choice});
      return {{"enum", choices}};
    }
    case Form::Switch:
      return {{"type", "boolean"}};
    case Form::Text:
      return {{"type", "string"}};
    case Form::List:
      return {{"anyOf",
               {{{"type", "string"}},
                {{"type", "array"},
                 {"items", {{"type", "string"}}},
                 {"minItems", static_cast<int>(range.low)},
                 {"maxItems", static_cast<int>(range.high)}}}}};
    case Form::Words:
      return {{"anyOf",
               {{{"type", "string"}},
                {{"type", "array"},
                 {"items", {{"type", {"integer", "string"}}}},
                 {"minItems", static_cast<int>(range.low)},
                 {"maxItems", static_cast<int>(range.high)}}}}};
    case Form::Value:
    case Form::Hexadecimal:
      return {{"type", {"number", "string"}}};
    case Form::Any:
      break;
  }
  return Json::object();
}

Json request_schema(const Method& method) {
  Json properties = Json::object();
  Json required = Json::array();
  if (method.scope == Scope::Unit) properties["unit"] = reference("unit");
  for (const Parameter& parameter : method.parameters) {
    Json schema = schema_of(parameter);
    schema["description"] = std::string{parameter.help};
    properties[std::string{parameter.key}] = std::move(schema);
    if (parameter.absent.empty()) required.push_back(std::string{parameter.key});
  }
  const bool needs_params = !required.empty();
  Json params{{"type", "object"}, {"properties", std::move(properties)}, {"required", std::move(required)}};
  Json all = Json::array({"method"});
  if (needs_params) all.push_back("params");
  return {{"type", "object"},
          {"description", std::string{method.summary}},
          {"properties",
           {{"id", reference("id")},
            {"method", {{"const", std::string{method.name}}}},
            {"params", std::move(params)}}},
          {"required", std::move(all)}};
}

Json error_schema() {
  Json codes = Json::array();
  for (const ErrorName& row : kErrorNames) codes.push_back(std::string{row.name});
  return {
      {"type", "object"},
      {"description", "the request was not carried out"},
      {"properties",
       {{"id", reference("id")},
        {"error",
         {{"type", "object"},
          {"properties",
           {{"code", {{"enum", std::move(codes)}}},
            {"message", {{"type", "string"}, {"description", "one line: what was wrong, and what was expected"}}},
            {"limits",
             {{"type", "object"},
              {"description", "what holds, of a number that is out of range"},
              {"properties", {{"low", {{"type", "number"}}}, {"high", {{"type", "number"}}}}}}}}},
          {"required", {"code", "message"}}}}}},
      {"required", {"id", "error"}}};
}

Json answer_schema(const Json& result) {
  return {{"type", "object"},
          {"properties", {{"id", reference("id")}, {"result", result}}},
          {"required", {"id", "result"}}};
}

}  // namespace

std::string write_schema(const ProtocolText& text) {
  Json definitions = text.definitions;
  definitions["id"] = {{"type", {"number", "string", "null"}}, {"description", "handed back as it came"}};
  definitions["unit"] = {
      {"type", "string"},
      {"description", "the unit that is meant: 5, vcan0/5; may be left out where the daemon has one alone"}};
  definitions["error"] = error_schema();
  Json requests = Json::array(), answers = Json::array(), notices = Json::array();
  for (const Chapter& chapter : text.chapters)
    for (const MethodText& method : chapter.methods) {
      const std::string name{method.row.name};
      definitions["request." + name] = request_schema(method.row);
      definitions["result." + name] =
          method.result == nullptr ? Json{{"type", "object"}, {"properties", Json::object()}} : *method.result;
      definitions["answer." + name] = answer_schema(reference("result." + name));
      requests.push_back(reference("request." + name));
      answers.push_back(reference("answer." + name));
    }
  answers.push_back(reference("error"));
  for (const auto& item : text.notices.items()) {
    definitions["notice." + item.key()] = {
        {"type", "object"}, {"properties", {{item.key(), item.value()}}}, {"required", Json::array({item.key()})}};
    notices.push_back(reference("notice." + item.key()));
  }
  Json lines = Json::array({reference("request"), reference("answer")});
  definitions["request"] = {{"description", "a line to the daemon"}, {"anyOf", std::move(requests)}};
  definitions["answer"] = {{"description", "a line from the daemon"}, {"anyOf", std::move(answers)}};
  if (!notices.empty()) {
    definitions["notice"] = {{"description", "a line from the daemon that a subscription brings"},
                             {"anyOf", std::move(notices)}};
    lines.push_back(reference("notice"));
  }
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Lines of the control socket of axisd"},
                    {"description", "Of one method: $defs/request.METHOD, $defs/result.METHOD"},
                    {"anyOf", std::move(lines)},
                    {"$defs", std::move(definitions)}};
  return schema.dump(kIndent) + '\n';
}

}  // namespace control
