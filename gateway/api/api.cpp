#include "gateway/api/api.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "gateway/base/json_text.hpp"
#include "gateway/base/percent.hpp"
#include "gateway/openapi/document.hpp"
#include "gateway/routes/arguments.hpp"
#include "text/number.hpp"

namespace gateway {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, Error>;

Outcome no(Refused why, std::string message) {
  return tl::unexpected{refuse(why, std::move(message))};
}

bool is_safe(std::string_view verb) noexcept {
  return verb == "GET" || verb == "HEAD" || verb == "OPTIONS";
}

Credentials credentials_of(const Request& request) {
  return {.hosts = request.header("host"),
          .origins = request.header("origin"),
          .authorizations = request.header("authorization"),
          .is_write = !is_safe(request.verb)};
}

bool is_json(std::string_view type) {
  const std::string_view essence = type.substr(0, type.find(';'));
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(essence.substr(0, essence.find_last_not_of(' ') + 1), kJson, {}, lower);
}

/// Whether the body that is announced is one that can be taken.
Outcome check_body(const Request& request) {
  const auto lengths = request.header("content-length");
  const bool is_chunked = !request.header("transfer-encoding").empty();
  const auto length = lengths.empty() ? std::size_t{0} : text::integer<std::size_t>(lengths.front());
  if (!length || *length > HttpServer::kLongestBody)
    return no(Refused::TooLong, fmt::format("the body is longer than {} bytes", HttpServer::kLongestBody));
  if (*length == 0 && !is_chunked) return {};
  const auto types = request.header("content-type");
  if (types.size() == 1 && is_json(types.front())) return {};
  return no(Refused::NotJson, "the body: expected the header Content-Type: application/json");
}

/// The query without its percent-encoding.
tl::expected<Query, Error> query_of(const Request& request) {
  Query query;
  for (const auto& [key, value] : request.query) {
    auto plain_key = decoded(key);
    auto plain_value = decoded(value);
    if (!plain_key || !plain_value)
      return tl::unexpected{refuse(Refused::BadRequest, "the query: its percent-encoding is none")};
    query.emplace_back(*std::move(plain_key), *std::move(plain_value));
  }
  return query;
}

void answer_with(const std::shared_ptr<Exchange>& exchange, const Answer& answer) {
  if (!answer) return exchange->answer(answer.error());
  exchange->answer(Response{.body = json_text(*answer) + '\n'});
}

/// What browsers ask before a page of another origin may do more than read.
void answer_options(Exchange& exchange, std::string verbs, bool is_shared) {
  Response response{.status = Status::NoContent, .content_type = ""};
  if (is_shared) {
    response.headers.emplace_back("Access-Control-Allow-Methods", verbs);
    response.headers.emplace_back("Access-Control-Allow-Headers", "Authorization, Content-Type, Last-Event-ID");
  }
  response.headers.emplace_back("Allow", std::move(verbs));
  exchange.answer(std::move(response));
}

}  // namespace

/// First whether the caller is one to be told anything, then what is there, last whether it may be changed.
Outcome Api::check(const Request& request) const {
  Credentials credentials = credentials_of(request);
  const bool is_write = std::exchange(credentials.is_write, false);
  if (auto outcome = check_access(rules_, credentials); !outcome) return outcome;
  if (request.verb == "OPTIONS") return {};
  if (const auto match = find_route(request.verb, request.path); !match) return tl::unexpected{match.error()};
  credentials.is_write = is_write;
  if (auto outcome = check_access(rules_, credentials); !outcome) return outcome;
  return check_body(request);
}

void Api::on_headers(Exchange& exchange) {
  const Request& request = exchange.request();
  if (!rules_.allow_origins.empty()) exchange.add_header("Vary", "Origin");
  const auto shared = shared_origin(rules_, credentials_of(request));
  if (shared) exchange.add_header("Access-Control-Allow-Origin", *shared);
  if (const auto outcome = check(request); !outcome) return exchange.answer(outcome.error());
  if (request.verb != "OPTIONS") return;
  std::string verbs = verbs_of(request.path);
  if (verbs.empty()) return exchange.answer(find_route("GET", request.path).error());
  answer_options(exchange, std::move(verbs), shared.has_value());
}

void Api::on_request(const std::shared_ptr<Exchange>& exchange) {
  const Request& request = exchange->request();
  const auto match = find_route(request.verb, request.path);
  if (!match) return exchange->answer(match.error());
  const auto query = query_of(request);
  if (!query) return exchange->answer(query.error());
  auto params = arguments_of(*match, *query, match->route->is_write() ? request.body : std::string{});
  if (!params) return exchange->answer(params.error());
  switch (match->route->kind) {
    case Kind::Call:
    case Kind::Axis:
    case Kind::Samples:
    case Kind::Frames:
      return call(exchange, *match, *std::move(params));
    case Kind::Units:
      return answer_units(exchange, sources_.daemons);
    case Kind::Events:
      return sources_.events.open(exchange, *query);
    case Kind::Recent:
      return exchange->answer(sources_.recent.answer(*query, *params));
    case Kind::Live:
      return sources_.live.answer(exchange, unit_of(*match), *params);
    case Kind::Metrics:
      return answer_metrics(exchange, sources_.daemons, *counters_);
    case Kind::Document:
      return exchange->answer(Response{.body = std::string{openapi_document()}});
    case Kind::Server:
      return exchange->answer(server_page(rules_, request));
    case Kind::Overview:
      return all_units_.answer(exchange);
    case Kind::Eds:
      return send_eds(exchange, *match);
    case Kind::Start:
      return exchange->answer(start_page(request, sources_.page));
    case Kind::Asset:
      return exchange->answer(asset_of(request, match->value("name"), sources_.page));
  }
}

void Api::send_eds(const std::shared_ptr<Exchange>& exchange, const Match& match) const {
  const std::string unit = unit_of(match);
  const auto daemon = sources_.daemons.find(unit);
  if (!daemon) return exchange->answer(daemon.error());
  sources_.eds.answer(exchange, unit, **daemon);
}

void Api::call(const std::shared_ptr<Exchange>& exchange, const Match& match, json params) const {
  const std::string unit = unit_of(match);
  const auto daemon = sources_.daemons.find(unit);
  if (!daemon) return exchange->answer(daemon.error());
  const Route& route = *match.route;
  if (control::find_method(route.method)->scope == control::Scope::Unit) params["unit"] = unit;
  if (route.kind == Kind::Samples) return sources_.samples.open(exchange, params);
  if (route.kind == Kind::Frames) return sources_.frames.open(exchange, params);
  if (route.kind == Kind::Call)
    return (*daemon)->ask(route.method, params,
                          [exchange](const Answer& answer) { answer_with(exchange, answer); });
  (*daemon)->ask(route.method, params, [exchange, axis = std::string{match.value("axis")}](const Answer& answer) {
    answer_axis(exchange, axis, answer);
  });
}

}  // namespace gateway
