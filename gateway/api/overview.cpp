#include "gateway/api/overview.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "gateway/api/gathering.hpp"
#include "gateway/api/own_metrics.hpp"
#include "gateway/base/json_text.hpp"
#include "gateway/metrics/exposition.hpp"
#include "gateway/page/page_answer.hpp"
#include "gateway/routes/routes.hpp"
#include "gateway/units/unit_list.hpp"
#include "json/strict.hpp"
#include "text/number.hpp"
#include "version/version.hpp"

namespace gateway {
namespace {

using nlohmann::json;

std::string text_of(const json& value) {
  return json_text(value) + '\n';
}

/// What the daemon at @p path tells of itself besides its units, whose names stand in their place.
json daemon_of(json result, const std::string& path) {
  json names = json::array();
  for (const json& unit : result["units"]) names.push_back(unit.value("unit", ""));
  result["units"] = std::move(names);
  result["socket"] = path;
  return result;
}

}  // namespace

void answer_units(const std::shared_ptr<Exchange>& exchange, const Daemons& daemons) {
  std::vector<std::string> paths;
  for (const DaemonClient* const client : daemons.clients()) paths.push_back(client->path());
  const auto gathering = Gathering::make(paths.size(), [exchange, paths](const Gathering::Answers& answers) {
    json result{{"units", json::array()}, {"daemons", json::array()}};
    for (std::size_t at = 0; at < answers.size(); ++at) {
      if (!answers[at] || !answers[at]->is_object() || !answers[at]->contains("units")) continue;
      for (const json& unit : answers[at]->at("units")) result["units"].push_back(unit);
      result["daemons"].push_back(daemon_of(*answers[at], paths[at]));
    }
    exchange->answer(Response{.body = text_of(result)});
  });
  for (DaemonClient* const client : daemons.clients()) ask_for_units(*client, gathering->place());
}

/// Two answers a unit, in the order of the names.
void answer_metrics(const std::shared_ptr<Exchange>& exchange, const Daemons& daemons, const Counters& counters) {
  const std::vector<std::string> names = daemons.units();
  std::vector<std::string> hosts;
  hosts.reserve(names.size());
  for (const std::string& name : names) hosts.push_back(daemons.host_of(name));
  const std::string own = own_metrics(counters, daemons.clients().size(), names.size());
  const auto gathering =
      Gathering::make(2 * names.size(), [exchange, names, hosts, own](Gathering::Answers answers) {
        std::vector<UnitSample> units;
        for (std::size_t at = 0; at < names.size(); ++at)
          units.push_back(
              {names[at], answers[2 * at].value_or(nullptr), answers[2 * at + 1].value_or(nullptr), hosts[at]});
        exchange->answer(Response{.body = exposition(units) + own, .content_type = kExpositionType});
      });
  for (const std::string& name : names)
    for (const std::string_view method : {"status", "metrics"})
      daemons.find(name).value()->ask(method, {{"unit", name}}, gathering->place());
}

void answer_axis(const std::shared_ptr<Exchange>& exchange, const std::string& axis, const Answer& status) {
  if (!status) return exchange->answer(status.error());
  const auto number = text::integer<unsigned>(axis);
  const json axes = status->value("axes", json::array());
  const auto found = std::ranges::find_if(axes, [number](const json& each) {
    return number && each.is_object() && each.value("axis", 0U) == *number;
  });
  if (found != axes.end()) return exchange->answer(Response{.body = text_of(*found)});
  exchange->answer(refused_by_daemon(
      control::ErrorCode::NotFound,
      fmt::format("axis: expected an integer 1 to {}, got {}", axes.size(), json_text::quote(axis)), nullptr));
}

Response server_page(const AccessRules& rules, const Request& request) {
  return {.body = text_of({{"program", "axisd-http"},
                           {"version", version::number()},
                           {"read_only", rules.read_only},
                           {"token", name_of(token_state(rules, request.header("authorization")))}})};
}

Response asset_of(const Request& request, std::string_view name, const PageFiles& page) {
  const PageFile* const file = page.asset(name);
  if (file != nullptr) return page_answer(request, *file, Keep::ForEver);
  return response_of(refuse(Refused::NoSuchPath, "the page has no such file"));
}

Response start_page(const Request& request, const PageFiles& page) {
  const auto accepted = request.header("accept");
  const bool wants_page = std::ranges::any_of(
      accepted, [](const std::string& types) { return types.find("text/html") != std::string::npos; });
  if (wants_page && page.start() != nullptr) {
    Response response = page_answer(request, *page.start(), Keep::Asks);
    response.headers.emplace_back("Vary", "Accept");
    return response;
  }
  json links = json::object();
  std::string items;
  for (const Route& route : routes()) {
    if (route.verb != "GET" || route.path.find('{') != std::string_view::npos) continue;
    const std::string_view summary = summary_of(route);
    links[std::string{route.path}] = summary;
    items += fmt::format("<li><a href=\"{0}\">{0}</a> {1}\n", route.path, summary);
  }
  if (!wants_page)
    return {.body = text_of({{"program", "axisd-http"}, {"resources", links}}), .headers = {{"Vary", "Accept"}}};
  return {
      .body = fmt::format("<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>axisd-http</title>\n"
                          "<h1>axisd-http</h1>\n<ul>\n{}</ul>\n",
                          items),
      .content_type = "text/html; charset=utf-8"};
}

}  // namespace gateway
