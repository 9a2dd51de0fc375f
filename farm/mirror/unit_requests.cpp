#include "farm/mirror/unit_requests.hpp"

#include <utility>

#include <fmt/format.h>

#include "control/protocol.hpp"
#include "farm/naming/subjects.hpp"

namespace farm {
namespace {

using control::ErrorCode;
using nlohmann::json;

std::string text_of_request(const UnitRequests::Request& request) {
  json object{{"id", request.id}, {"method", request.method}, {"params", request.params}};
  if (!request.deliver.empty()) object["deliver"] = request.deliver;
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Whether @p text is a line that answers the request with @p id.
bool is_answer(const std::string& text, const json& id) {
  const json object = control::parse_line(text);
  return object.is_object() && object.value("id", json{}) == id && text.find('\n') == std::string::npos &&
         (object.contains("result") || object.contains("error"));
}

}  // namespace

control::Error unreachable(std::string message) {
  return {ErrorCode::Unreachable, std::move(message)};
}

void UnitRequests::ask(Request request, OnLine on_line) {
  const std::string text = text_of_request(request);
  if (text.size() > control::kMaximumLine)
    return on_line(control::error_line(
        request.id, {ErrorCode::Overflow,
                     fmt::format("the request is longer than {} bytes on its way", control::kMaximumLine)}));
  const std::string subject = rpc_subject(farm_, request.unit.unit.name);
  const std::uint64_t number = ++last_;
  under_way_.emplace(number, UnderWay{std::move(request), std::move(on_line)});
  messages_.request(subject, text, patience_,
                    [this, number, life = std::weak_ptr{life_}](const Messages::Reply& reply) {
                      if (!life.expired()) take(number, reply);
                    });
}

void UnitRequests::take(std::uint64_t number, const Messages::Reply& reply) {
  const auto found = under_way_.find(number);
  if (found == under_way_.end()) return;
  const UnderWay done = std::move(found->second);
  under_way_.erase(found);
  done.on_line(line_of(done.request, reply));
}

std::string UnitRequests::line_of(const Request& request, const Messages::Reply& reply) const {
  const std::string unit = request.unit.unit.name.text();
  if (!reply) {
    if (reply.error() == NoReply::TooMuch)
      return control::error_line(request.id, {ErrorCode::Overflow, std::string{text_of(NoReply::TooMuch)}});
    return control::error_line(request.id, unreachable(fmt::format("{} on host {}: {}", unit, request.unit.host,
                                                                   text_of(reply.error()))));
  }
  if (reply->size() >= control::kMaximumLine)
    return control::error_line(
        request.id,
        {ErrorCode::Overflow, fmt::format("{}: the answer is longer than {} bytes", unit, control::kMaximumLine)});
  if (is_answer(*reply, request.id)) return *reply + '\n';
  return control::error_line(
      request.id, unreachable(fmt::format("{} on host {}: what came is no answer", unit, request.unit.host)));
}

void UnitRequests::give_up(const std::string& host) {
  std::map<std::uint64_t, UnderWay> lost;
  for (auto each = under_way_.begin(); each != under_way_.end();) {
    const auto next = std::next(each);
    if (each->second.request.unit.host == host) lost.insert(under_way_.extract(each));
    each = next;
  }
  for (auto& [number, under_way] : lost)
    under_way.on_line(control::error_line(
        under_way.request.id,
        unreachable(fmt::format("{}: its host {} is silent", under_way.request.unit.unit.name.text(), host))));
}

}  // namespace farm
