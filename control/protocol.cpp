#include "control/protocol.hpp"

#include <algorithm>
#include <utility>

namespace control {

namespace {

using nlohmann::json;

constexpr int kDeepest = 8;  // levels of objects and arrays
constexpr std::size_t kQuotedText = 60;

std::string to_line(const json& object) {
  // A text that is not UTF-8 (a name from a file, say) must not end the conversation.
  return object.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

/// The beginning of @p line, fit for a message.
std::string quoted(std::string_view line) {
  std::string text{line.substr(0, kQuotedText)};
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + text + (line.size() > kQuotedText ? "\"..." : "\"");
}

}  // namespace

json parse_line(std::string_view line) {
  // What is nested deep needs much stack to walk through.
  bool too_deep = false;
  const auto watch_depth = [&](int depth, json::parse_event_t, const json&) {
    too_deep = too_deep || depth > kDeepest;
    return !too_deep;
  };
  json value = json::parse(line, watch_depth, /*allow_exceptions=*/false);
  return too_deep ? json(json::value_t::discarded) : value;
}

tl::expected<Request, RequestError> parse_request(std::string_view line) {
  json object = parse_line(line);
  const auto refuse = [&](std::string message) {
    return tl::unexpected{RequestError{{}, {ErrorCode::Malformed, std::move(message)}}};
  };
  if (!object.is_object()) return refuse("expected a JSON object, got " + quoted(line));
  Request request;
  if (const auto id = object.find("id"); id != object.end()) request.id = std::move(*id);
  if (request.id.is_structured()) return refuse("id: expected a number or a string");
  const auto refuse_it = [&](std::string message) {
    return tl::unexpected{RequestError{std::move(request.id), {ErrorCode::Malformed, std::move(message)}}};
  };
  const auto method = object.find("method");
  if (method == object.end() || !method->is_string()) return refuse_it("method: expected a string");
  request.method = method->get<std::string>();
  if (const auto params = object.find("params"); params != object.end()) request.params = std::move(*params);
  if (!request.params.is_object()) return refuse_it("params: expected an object");
  return request;
}

std::string request_line(int id, std::string_view method, const json& params) {
  json object{{"id", id}, {"method", method}};
  if (!params.empty()) object["params"] = params;
  return to_line(object);
}

std::string result_line(const json& id, const json& result) {
  return to_line({{"id", id}, {"result", result}});
}

std::string error_line(const json& id, const Error& error) {
  json object = error.details.is_object() ? error.details : json::object();
  object["code"] = name_of(error.code);
  object["message"] = error.message;
  return to_line({{"id", id}, {"error", std::move(object)}});
}

std::string notice_line(std::string_view key, const json& value) {
  return to_line({{key, value}});
}

tl::expected<json, AnswerError> parse_answer(std::string_view line, int id) {
  json object = parse_line(line);
  const auto not_an_answer = [line] {
    return tl::unexpected{AnswerError{.message = "not an answer: " + quoted(line)}};
  };
  if (!object.is_object()) return not_an_answer();
  if (const auto error = object.find("error"); error != object.end()) {
    const auto message = error->is_object() ? error->find("message") : error->end();
    if (!error->is_object() || message == error->end() || !message->is_string()) return not_an_answer();
    AnswerError refusal{.is_answer = true, .message = message->get<std::string>(), .details = *error};
    if (const auto code = error->find("code"); code != error->end() && code->is_string())
      refusal.code = error_code_of(code->get_ref<const std::string&>());
    refusal.details.erase("code");
    refusal.details.erase("message");
    return tl::unexpected{std::move(refusal)};
  }
  const auto result = object.find("result");
  if (result == object.end() || object.value("id", json{}) != id) return not_an_answer();
  return std::move(*result);
}

}  // namespace control
