#include "tools/axisctl/connection/client.hpp"

#include <array>
#include <cerrno>
#include <deque>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <sys/socket.h>

#include "control/discovery/trusted_server.hpp"
#include "control/protocol.hpp"
#include "os/clock.hpp"

namespace axisctl {

namespace {

using nlohmann::json;

// A daemon that is alive answers within a turn of its event loop.
constexpr std::chrono::seconds kPatience{10};
constexpr std::chrono::seconds kForEver{0};
/// Requests that are sent before the answer to the first one is read.
constexpr std::size_t kMostAtATime = 64;

std::string reason() {
  return std::generic_category().message(errno);
}

/// Whether @p line tells something that was subscribed to.
bool is_notice(const std::string& line) {
  const json object = control::parse_line(line);
  return object.is_object() && !object.empty() && !object.contains("id") && !object.contains("result");
}

}  // namespace

Expected<Client> Client::connect(const std::string& path) {
  auto socket = control::connect_to(path, kPatience);
  if (!socket) return fail(ExitStatus::NotReachable, socket.error());
  return Client{path, *std::move(socket)};
}

bool Client::send_all(std::string_view rest) {
  while (!rest.empty()) {
    const ssize_t sent = ::send(socket_.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

Expected<std::string> Client::read_line() {
  const auto failed = [this](ExitStatus status, std::string_view what) {
    return fail(status, fmt::format("{}: {}", name_, what));
  };
  std::array<char, 4096> part{};
  while (true) {
    const std::size_t end = input_.find('\n');
    if (std::min(end, input_.size()) >= control::kMaximumLine)
      return failed(ExitStatus::NotUnderstood,
                    fmt::format("the answer is longer than {} bytes", control::kMaximumLine));
    if (end != std::string::npos) {
      std::string line = input_.substr(0, end);
      input_.erase(0, end + 1);
      return line;
    }
    if (os::other_time != nullptr) os::other_time->wait_readable(socket_.get());
    const ssize_t size = ::recv(socket_.get(), part.data(), part.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
      return failed(ExitStatus::TimedOut, fmt::format("no answer within {} s", kPatience.count()));
    if (size == 0 || (size < 0 && errno == ECONNRESET))
      return failed(ExitStatus::CutOff, "the daemon closed the connection without an answer");
    if (size < 0) return failed(ExitStatus::Failed, reason());
    input_.append(part.data(), static_cast<std::size_t>(size));
  }
}

Expected<int> Client::send(const Call& call) {
  control::set_patience(socket_, kPatience);
  const int id = ++last_id_;
  if (os::other_time != nullptr) os::other_time->note_touched();
  // A daemon that closes the connection before it has read the request may have said why.
  if (send_all(control::request_line(id, call.method, call.params)) || errno == EPIPE) return id;
  return fail(ExitStatus::Failed, fmt::format("{}: {}", name_, reason()));
}

Expected<json> Client::answer_to(int id) {
  while (true) {
    const auto line = read_line();
    if (!line) return tl::unexpected{line.error()};
    auto answer = control::parse_answer(*line, id);
    if (answer) return *std::move(answer);
    control::AnswerError& error = answer.error();
    if (!error.is_answer && is_notice(*line)) continue;
    if (error.code) error.details["code"] = control::name_of(*error.code);
    const ExitStatus status = error.code        ? status_of(*error.code)
                              : error.is_answer ? ExitStatus::Failed
                                                : ExitStatus::NotUnderstood;
    return tl::unexpected{
        Failure{.status = status, .message = std::move(error.message), .details = std::move(error.details)}};
  }
}

Expected<json> Client::ask(const Call& call) {
  return send(call).and_then([this](int id) { return answer_to(id); });
}

std::vector<Expected<json>> Client::ask_all(std::span<const Call> calls) {
  std::vector<Expected<json>> results;
  std::deque<Expected<int>> asked;
  for (std::size_t next = 0; results.size() < calls.size();) {
    while (next < calls.size() && asked.size() < kMostAtATime) asked.push_back(send(calls[next++]));
    results.push_back(asked.front().and_then([this](int id) { return answer_to(id); }));
    asked.pop_front();
  }
  return results;
}

Expected<std::optional<json>> Client::next_notice() {
  control::set_patience(socket_, kForEver);
  const auto line = read_line();
  if (!line && line.error().status == ExitStatus::CutOff) return std::nullopt;
  if (!line) return tl::unexpected{line.error()};
  json notice = control::parse_line(*line);
  if (!notice.is_object()) return fail(ExitStatus::NotUnderstood, name_ + ": expected an object a line");
  if (const auto error = notice.find("error"); error != notice.end() && error->is_object())
    return fail(ExitStatus::CutOff, fmt::format("{}: {}", name_, error->value("message", "the daemon gives up")));
  return notice;
}

Expected<json> ask(const std::string& path, const Call& call) {
  auto client = Client::connect(path);
  if (!client) return tl::unexpected{client.error()};
  return client->ask(call);
}

}  // namespace axisctl
