#include "gateway/routes/arguments.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "control/protocol.hpp"
#include "gateway/base/percent.hpp"
#include "gateway/routes/own_parameters.hpp"
#include "json/strict.hpp"
#include "text/number.hpp"

namespace gateway {
namespace {

using control::Form;
using control::Parameter;
using nlohmann::json;

tl::unexpected<Error> bad(std::string message) {
  return tl::unexpected{refuse(Refused::BadRequest, std::move(message))};
}

/// The parameter of @p route called @p key that comes from @p source; nullptr if there is none.
const Parameter* find(const Route& route, ArgumentSource source, std::string_view key) {
  const auto all = parameters_of(route);
  const auto found = std::ranges::find(all, key, &Parameter::key);
  return found != all.end() && source_of(route, key) == source ? &*found : nullptr;
}

/// "known are a, b", for a message.
std::string known(const Route& route, ArgumentSource source) {
  std::string names;
  if (source == ArgumentSource::Query && route.kind == Kind::Events) names = kUnitFilter;
  for (const Parameter& parameter : parameters_of(route))
    if (source_of(route, parameter.key) == source) names.append(names.empty() ? "" : ", ").append(parameter.key);
  return names.empty() ? "it takes none" : "known are " + names;
}

json real_of(std::string_view text) {
  const auto number = text::real(text);
  return number ? json(*number) : json(text);
}

json integer_of(std::string_view text) {
  const auto number = text::integer<std::int64_t>(text);
  return number ? json(*number) : json(text);
}

json switch_of(std::string_view text) {
  if (text == "true" || text == "false") return text == "true";
  return text;
}

}  // namespace

json value_of(Form form, std::string_view text) {
  switch (form) {
    case Form::Axis:
    case Form::Place:
    case Form::Integer:
    case Form::Terminal:
    case Form::Fault:
      return integer_of(text);
    case Form::Number:
      return real_of(text);
    case Form::Switch:
      return switch_of(text);
    case Form::List:
      return list_of(text);
    case Form::Choice:
    case Form::Text:
    case Form::Words:
    case Form::Value:
    case Form::Hexadecimal:
    case Form::Any:
      break;
  }
  return text;
}

tl::expected<json, Error> arguments_of(const Match& match, const Query& query, std::string_view body) {
  const Route& route = *match.route;
  json params = json::object();
  for (const Parameter& parameter : parameters_of(route))
    if (source_of(route, parameter.key) == ArgumentSource::Path)
      params[std::string{parameter.key}] =
          value_of(parameter.form, match.value(name_in_path(route, parameter.key)));
  for (const auto& [key, text] : query) {
    if (route.kind == Kind::Events && key == kUnitFilter) continue;
    const Parameter* const parameter = find(route, ArgumentSource::Query, key);
    if (parameter == nullptr)
      return bad(fmt::format("{}: no such parameter in the query, {}", json_text::quote(key),
                             known(route, ArgumentSource::Query)));
    if (params.contains(key)) return bad(fmt::format("{}: is there twice", json_text::quote(key)));
    params[key] = value_of(parameter->form, text);
  }
  if (body.empty()) return params;
  const json object = control::parse_line(body);
  if (!object.is_object()) return bad("the body: expected a JSON object, nested at most eight levels deep");
  for (const auto& [key, value] : object.items()) {
    if (find(route, ArgumentSource::Body, key) == nullptr)
      return bad(fmt::format("{}: no such member of the body, {}", json_text::quote(key),
                             known(route, ArgumentSource::Body)));
    params[key] = value;
  }
  return params;
}

}  // namespace gateway
