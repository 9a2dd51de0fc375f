#include "farm/mirror/event_relay.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "control/protocol.hpp"
#include "farm/naming/subjects.hpp"

namespace farm {

using nlohmann::json;

void EventRelay::subscribe(Connections::Id client, Filter filter) {
  end(client);
  const std::string subject = filter.unit ? event_subject(farm_, *filter.unit) : all_events_subject(farm_);
  subscriptions_[client] = {subject, std::move(filter.kinds)};
  std::set<Connections::Id>& clients = clients_[subject];
  if (clients.empty())
    messages_.subscribe(subject, [this, subject](const Message& message) { take(subject, message); });
  clients.insert(client);
}

void EventRelay::end(Connections::Id client) {
  const auto subscription = subscriptions_.find(client);
  if (subscription == subscriptions_.end()) return;
  const auto clients = clients_.find(subscription->second.subject);
  clients->second.erase(client);
  if (clients->second.empty()) {
    messages_.unsubscribe(clients->first);
    clients_.erase(clients);
  }
  subscriptions_.erase(subscription);
}

void EventRelay::give_up(const control::Error& why) {
  for (const auto& [client, subscription] : subscriptions_) connections_.end(client, why);
}

/// The text goes on as it has come.
void EventRelay::take(const std::string& subject, const Message& message) {
  const json event = control::parse_line(message.data);
  const bool is_line = message.data.find('\n') == std::string_view::npos;
  const std::string line = fmt::format("{{\"event\":{}}}\n", message.data);
  if (!event.is_object() || !is_line || line.size() > control::kMaximumLine) {
    ++strange_;
    return;
  }
  const auto member = event.find("kind");
  const std::string kind = member != event.end() && member->is_string() ? member->get<std::string>() : "";
  for (const Connections::Id client : clients_[subject]) {
    const std::vector<std::string>& kinds = subscriptions_[client].kinds;
    if (kinds.empty() || std::ranges::find(kinds, kind) != kinds.end()) connections_.tell(client, line);
  }
}

}  // namespace farm
