#include "gateway/units/daemon_client.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "control/protocol.hpp"
#include "os/clock.hpp"

namespace gateway {
namespace {

using nlohmann::json;

constexpr std::int64_t kPatience = 10'000'000;  // µs

std::int64_t now() noexcept {
  return std::chrono::duration_cast<std::chrono::microseconds>(os::monotonic_time()).count();
}

/// The key of a line that nobody has asked for; empty if @p line is none.
std::string notice_key(const json& line) {
  if (!line.is_object() || line.size() != 1) return {};
  std::string key = line.begin().key();
  return key == "id" || key == "result" || key == "error" ? std::string{} : key;
}

/// Why the connection ends with @p line, which is neither an answer nor a notice: the daemon says it, or that is
/// why.
std::string last_word(const json& line) {
  const json error = line.is_object() && line.value("id", json{}).is_null() ? line.value("error", json{}) : json{};
  const json message = error.is_object() ? error.value("message", json{}) : json{};
  return message.is_string() && !message.get_ref<const std::string&>().empty()
             ? message.get<std::string>()
             : "the daemon sent what is no line of the protocol";
}

/// A notice as text: {"KEY":{...}}.
struct NoticeText {
  std::string_view key;
  std::string_view value;
};

/// What begins and ends as the daemon writes a notice, without a look at the middle, which is long. An answer does
/// not: it has an `id`. What has control characters is for the parser to refuse.
std::optional<NoticeText> notice_text(std::string_view line) noexcept {
  constexpr std::string_view kBegin = "{\"";
  constexpr std::string_view kMiddle = "\":{";
  if (!line.starts_with(kBegin) || !line.ends_with("}}")) return std::nullopt;
  const std::size_t end = line.find('"', kBegin.size());
  if (end == std::string_view::npos || line.substr(end, kMiddle.size()) != kMiddle) return std::nullopt;
  const std::string_view key = line.substr(kBegin.size(), end - kBegin.size());
  const std::size_t value = end + kMiddle.size() - 1;
  const bool is_plain = std::ranges::none_of(line, [](char c) { return static_cast<unsigned char>(c) < ' '; });
  const bool is_answer = key == "id" || key == "result" || key == "error";
  if (is_answer || !is_plain) return std::nullopt;
  return NoticeText{key, line.substr(value, line.size() - value - 1)};
}

}  // namespace

DaemonClient::DaemonClient(axisd::ServiceEvents& events, std::string path, os::Descriptor socket,
                           Listener& listener)
    : path_{std::move(path)},
      listener_{listener},
      connection_{std::make_unique<LineConnection>(events, std::move(socket),
                                                   static_cast<LineConnection::Listener&>(*this))} {}

DaemonClient::~DaemonClient() {
  give_up(refuse(Refused::NoDaemon, fmt::format("{}: the connection to the daemon has ended", path_)));
}

void DaemonClient::ask(std::string_view method, const json& params, OnAnswer on_answer) {
  if (waiting_.size() >= kMostWaiting)
    return on_answer(tl::unexpected{
        refuse(Refused::TooMany, fmt::format("{} requests wait for the daemon already", waiting_.size()))});
  last_id_ = last_id_ == std::numeric_limits<int>::max() ? 1 : last_id_ + 1;
  const std::string line = control::request_line(last_id_, method, params);
  if (line.size() > control::kMaximumLine)
    return on_answer(tl::unexpected{refuse(
        Refused::TooLong,
        fmt::format("the request is longer than a line of the control socket, {} bytes", control::kMaximumLine))});
  if (!connection_ || !connection_->send(line))
    return on_answer(tl::unexpected{refuse(Refused::TooMany, "the daemon does not take any more requests")});
  waiting_.push_back({last_id_, now(), std::move(on_answer)});
}

bool DaemonClient::is_silent() const noexcept {
  return !waiting_.empty() && now() - waiting_.front().since > kPatience;
}

void DaemonClient::give_up(const Error& why) {
  connection_.reset();
  for (Waiting& waiting : std::exchange(waiting_, {})) waiting.on_answer(tl::unexpected{why});
}

std::string DaemonClient::on_line(std::string_view line) {
  if (const auto notice = notice_text(line); notice && listener_.on_notice_text(*this, notice->key, notice->value))
    return {};
  const json object = control::parse_line(line);
  if (const auto waiting = waiting_for(object); waiting != waiting_.end()) {
    auto answer = control::parse_answer(line, waiting->id);
    if (answer) return take_answer(waiting, *std::move(answer)), std::string{};
    control::AnswerError& error = answer.error();
    if (error.is_answer)
      return take_answer(waiting, tl::unexpected{refused_by_daemon(error.code, std::move(error.message),
                                                                   std::move(error.details))}),
             std::string{};
  }
  const std::string key = notice_key(object);
  if (key.empty()) return last_word(object);
  listener_.on_notice(*this, key, object.front());
  return {};
}

/// Answers come in the order of the requests, or, from a farm, as they come.
std::deque<DaemonClient::Waiting>::iterator DaemonClient::waiting_for(const json& answer) {
  const json id = answer.is_object() ? answer.value("id", json{}) : json{};
  return std::ranges::find_if(waiting_, [&id](const Waiting& waiting) { return id == waiting.id; });
}

void DaemonClient::take_answer(std::deque<Waiting>::iterator waiting, Answer answer) {
  const OnAnswer on_answer = std::move(waiting->on_answer);
  waiting_.erase(waiting);
  on_answer(std::move(answer));
}

void DaemonClient::on_closed(const std::string& why) {
  const Error error = refuse(Refused::BrokenDaemon, fmt::format("{}: {}", path_, why));
  for (Waiting& waiting : std::exchange(waiting_, {})) waiting.on_answer(tl::unexpected{error});
  listener_.on_gone(*this, why);
}

}  // namespace gateway
