#include "daemon/control_protocol.hpp"

#include <cstdlib>
#include <utility>

#include <sys/socket.h>
#include <unistd.h>

#include "text/number.hpp"

namespace control {

namespace {

using nlohmann::json;

constexpr int kDeepest = 8;  // levels of objects and arrays
constexpr std::string_view kPrefix = "axisd-";
constexpr std::string_view kSuffix = ".sock";
constexpr int kHighestNode = 127;
constexpr std::size_t kQuotedText = 60;

std::string_view environment(const char* name) noexcept {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view{} : std::string_view{value};
}

std::string to_line(const json& object) {
  // A text that is not UTF-8 (a name from a file, say) must not end the conversation.
  return object.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

/// The value in @p line; discarded if it is no JSON, or nested so deep that walking through it needs much stack.
json parse(std::string_view line) {
  bool too_deep = false;
  const auto watch_depth = [&](int depth, json::parse_event_t, const json&) {
    too_deep = too_deep || depth > kDeepest;
    return !too_deep;
  };
  json value = json::parse(line, watch_depth, /*allow_exceptions=*/false);
  return too_deep ? json(json::value_t::discarded) : value;
}

/// The beginning of @p line, fit for a message.
std::string quoted(std::string_view line) {
  std::string text{line.substr(0, kQuotedText)};
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + text + (line.size() > kQuotedText ? "\"..." : "\"");
}

}  // namespace

std::optional<Method> method_named(std::string_view name) noexcept {
  const auto* found =
      std::find_if(kMethods.begin(), kMethods.end(), [name](const MethodName& row) { return row.name == name; });
  return found == kMethods.end() ? std::nullopt : std::optional{found->method};
}

std::string runtime_directory() {
  // systemd.exec(5): several folders are separated by colons.
  const std::string_view own = environment("RUNTIME_DIRECTORY");
  if (const std::string_view first = own.substr(0, own.find(':')); !first.empty()) return std::string{first};
  if (const std::string_view user = environment("XDG_RUNTIME_DIR"); !user.empty()) return std::string{user};
  return ::geteuid() == 0 ? "/run" : "/tmp";
}

std::string default_socket_path(std::string_view label, int node) {
  std::string path = runtime_directory();
  path.append("/").append(kPrefix).append(label).append("-").append(std::to_string(node)).append(kSuffix);
  return path;
}

std::optional<SocketName> parse_socket_name(std::string_view file_name) noexcept {
  if (!file_name.starts_with(kPrefix) || !file_name.ends_with(kSuffix)) return std::nullopt;
  if (file_name.size() <= kPrefix.size() + kSuffix.size()) return std::nullopt;
  const std::string_view middle =
      file_name.substr(kPrefix.size(), file_name.size() - kPrefix.size() - kSuffix.size());
  const std::size_t dash = middle.rfind('-');
  if (dash == std::string_view::npos || dash == 0) return std::nullopt;
  const auto node = text::integer<int>(middle.substr(dash + 1));
  if (!node || *node < 0 || *node > kHighestNode) return std::nullopt;
  return SocketName{middle.substr(0, dash), *node};
}

tl::expected<sockaddr_un, std::string> socket_address(std::string_view path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty()) return tl::unexpected{std::string{"the path of a control socket is empty"}};
  if (path.size() >= sizeof address.sun_path)
    return tl::unexpected{std::string{path} + ": too long for a socket: " + std::to_string(path.size()) +
                          " bytes, at most " + std::to_string(sizeof address.sun_path - 1)};
  std::copy(path.begin(), path.end(), address.sun_path);
  return address;
}

tl::expected<Request, RequestError> parse_request(std::string_view line) {
  json object = parse(line);
  const auto refuse = [&](std::string message) { return tl::unexpected{RequestError{{}, std::move(message)}}; };
  if (!object.is_object()) return refuse("expected a JSON object, got " + quoted(line));
  Request request;
  if (const auto id = object.find("id"); id != object.end()) request.id = std::move(*id);
  if (request.id.is_structured()) return refuse("id: expected a number or a string");
  const auto refuse_it = [&](std::string message) {
    return tl::unexpected{RequestError{std::move(request.id), std::move(message)}};
  };
  const auto method = object.find("method");
  if (method == object.end() || !method->is_string()) return refuse_it("method: expected a string");
  request.method = method->get<std::string>();
  if (const auto params = object.find("params"); params != object.end()) request.params = std::move(*params);
  if (!request.params.is_object()) return refuse_it("params: expected an object");
  return request;
}

std::string request_line(int id, Method method, const json& params) {
  json object{{"id", id}, {"method", name_of(method)}};
  if (!params.empty()) object["params"] = params;
  return to_line(object);
}

std::string result_line(const json& id, const json& result) {
  return to_line({{"id", id}, {"result", result}});
}

std::string error_line(const json& id, std::string_view message) {
  return to_line({{"id", id}, {"error", {{"message", message}}}});
}

tl::expected<json, std::string> parse_answer(std::string_view line, int id) {
  json object = parse(line);
  const auto not_an_answer = [line] { return tl::unexpected{"not an answer: " + quoted(line)}; };
  if (!object.is_object()) return not_an_answer();
  if (const auto error = object.find("error"); error != object.end()) {
    const auto message = error->is_object() ? error->find("message") : error->end();
    if (!error->is_object() || message == error->end() || !message->is_string()) return not_an_answer();
    return tl::unexpected{message->get<std::string>()};
  }
  const auto result = object.find("result");
  if (result == object.end() || object.value("id", json{}) != id) return not_an_answer();
  return std::move(*result);
}

}  // namespace control
