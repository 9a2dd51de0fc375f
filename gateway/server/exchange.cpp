#include "gateway/server/exchange.hpp"

#include <algorithm>

namespace gateway {

std::vector<std::string> Request::header(std::string_view name) const {
  const auto is_same = [](char left, char right) {
    return ('A' <= left && left <= 'Z' ? static_cast<char>(left - 'A' + 'a') : left) == right;
  };
  std::vector<std::string> values;
  for (const auto& [key, value] : headers)
    if (std::ranges::equal(key, name, is_same)) values.push_back(value);
  return values;
}

Response response_of(const Error& error) {
  Response response{.status = error.status, .body = body_of(error)};
  if (!error.allow.empty()) response.headers.emplace_back("Allow", error.allow);
  if (error.status == Status::Unauthorized) response.headers.emplace_back("WWW-Authenticate", "Bearer");
  if (error.status == Status::ServiceUnavailable || error.status == Status::TooManyRequests)
    response.headers.emplace_back("Retry-After", "1");
  return response;
}

void Exchange::answer(Response response) {
  if (response_ || is_over_) return;
  response_ = std::move(response);
  if (on_answer_) on_answer_();
}

void Exchange::stream(std::shared_ptr<EventStream> stream, std::function<void()> on_gone) {
  if (response_) return;
  if (is_over_) return on_gone();
  stream_ = std::move(stream);
  on_gone_ = std::move(on_gone);
  answer(Response{.content_type = "text/event-stream"});
}

}  // namespace gateway
