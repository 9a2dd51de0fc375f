#include "farm/mirror/deliveries.hpp"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "control/protocol.hpp"

namespace farm {
namespace {

using nlohmann::json;

/// Signs of life without an answer, one after the other, after which a unit counts as lost.
constexpr unsigned kMostUnanswered = 2;

/// Subjects that nobody guesses.
std::string random_prefix() {
  std::random_device source;
  return fmt::format("_INBOX.axisd_{:08x}{:08x}{:08x}.", source(), source(), source());
}

/// "samples" of "samples.subscribe".
std::string stream_of(const std::string& method) {
  return method.substr(0, method.find('.'));
}

bool is_refusal(const std::string& line) {
  return control::parse_line(line).contains("error");
}

/// Whether @p text is, as it seems, a line of the control socket that nobody has asked for. What is in it is long.
bool is_notice(std::string_view text) noexcept {
  return text.starts_with("{\"") && text.ends_with("}}") && text.size() < control::kMaximumLine &&
         std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < ' '; });
}

}  // namespace

Deliveries::Deliveries(axisd::ServiceEvents& events, Messages& messages, UnitRequests& requests,
                       Connections& connections, std::chrono::milliseconds keep)
    : messages_{messages}, requests_{requests}, connections_{connections}, keep_{keep}, prefix_{random_prefix()} {
  timer_ = events.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<Deliveries*>(self)->keep();
        return 0;
      },
      this);
  axisd::ServiceEvents::start(timer_, keep_);
}

void Deliveries::subscribe(Connections::Id client, UnitRequests::Request request, UnitRequests::OnLine on_line) {
  const std::string stream = stream_of(request.method);
  Delivery& delivery = delivery_to(client, request.unit);
  if (!delivery.streams.contains(stream)) end(client, stream);
  delivery.streams.insert(stream);
  request.deliver = delivery.subject;
  requests_.ask(std::move(request),
                [this, subject = delivery.subject, stream, on_line = std::move(on_line)](const std::string& line) {
                  take_answer(subject, stream, line);
                  on_line(line);
                });
}

Deliveries::Delivery& Deliveries::delivery_to(Connections::Id client, const Directory::Entry& unit) {
  const auto known = std::ranges::find_if(all_, [&](const Delivery& each) {
    return each.client == client && each.unit.unit.name == unit.unit.name && each.unit.host == unit.host;
  });
  if (known != all_.end()) return *known;
  Delivery& made = all_.emplace_back(Delivery{client, unit, fmt::format("{}{}", prefix_, ++last_)});
  messages_.subscribe(made.subject, [this, subject = made.subject](const Message& message) {
    if (const Delivery* const delivery = find(subject)) take(*delivery, message);
  });
  return made;
}

Deliveries::Delivery* Deliveries::find(const std::string& subject) noexcept {
  const auto found = std::ranges::find(all_, subject, &Delivery::subject);
  return found == all_.end() ? nullptr : &*found;
}

void Deliveries::take_answer(const std::string& subject, const std::string& stream, const std::string& line) {
  Delivery* const delivery = find(subject);
  if (delivery == nullptr || !is_refusal(line)) return;
  delivery->streams.erase(stream);
  if (delivery->streams.empty()) drop(subject);
}

void Deliveries::take(const Delivery& delivery, const Message& message) {
  if (is_notice(message.data)) connections_.tell(delivery.client, fmt::format("{}\n", message.data));
}

void Deliveries::end(Connections::Id client, const std::string& stream) {
  const auto delivery = std::ranges::find_if(
      all_, [&](const Delivery& each) { return each.client == client && each.streams.contains(stream); });
  if (delivery == all_.end()) return;
  delivery->streams.erase(stream);
  if (delivery->streams.empty()) return drop(delivery->subject);
  requests_.ask({.unit = delivery->unit, .method = stream + ".unsubscribe", .deliver = delivery->subject},
                [](const std::string&) {});
}

void Deliveries::forget(Connections::Id client) {
  std::vector<std::string> subjects;
  for (const Delivery& delivery : all_)
    if (delivery.client == client) subjects.push_back(delivery.subject);
  for (const std::string& subject : subjects) drop(subject);
}

void Deliveries::drop(const std::string& subject) {
  const auto dropped = std::ranges::find(all_, subject, &Delivery::subject);
  if (dropped == all_.end()) return;
  requests_.ask({.unit = dropped->unit, .method = "end", .deliver = subject}, [](const std::string&) {});
  messages_.unsubscribe(subject);
  all_.erase(dropped);
}

void Deliveries::give_up(const std::string& host) {
  for (const Delivery& delivery : all_)
    if (delivery.unit.host == host)
      connections_.end(delivery.client, unreachable(fmt::format("{}: its host {} is silent",
                                                                delivery.unit.unit.name.text(), host)));
}

void Deliveries::give_up(const control::Error& why) {
  for (const Delivery& delivery : all_) connections_.end(delivery.client, why);
}

void Deliveries::keep() {
  axisd::ServiceEvents::start(timer_, keep_);
  std::vector<std::pair<Directory::Entry, std::string>> kept;
  for (Delivery& delivery : all_) {
    ++delivery.unanswered;
    kept.emplace_back(delivery.unit, delivery.subject);
  }
  for (auto& [unit, subject] : kept)
    requests_.ask({.unit = std::move(unit), .method = "keep", .deliver = subject},
                  [this, subject = subject](const std::string& line) { take_kept(subject, line); });
}

/// A door that was started anew does not know what it has to deliver. One that is slow once may be so.
void Deliveries::take_kept(const std::string& subject, const std::string& line) {
  Delivery* const delivery = find(subject);
  if (delivery == nullptr) return;
  if (!is_refusal(line)) {
    delivery->unanswered = 0;
    return;
  }
  const json code = control::parse_line(line)["error"].value("code", json{});
  if (code == control::name_of(control::ErrorCode::Unreachable) && delivery->unanswered < kMostUnanswered) return;
  connections_.end(delivery->client,
                   unreachable(fmt::format("{}: it delivers no more", delivery->unit.unit.name.text())));
}

}  // namespace farm
