#include "gateway/streams/unit_feed.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "gateway/base/json_text.hpp"

namespace gateway {
using nlohmann::json;

UnitFeed::UnitFeed(axisd::ServiceEvents& events, Daemons& daemons, const UnitFeedRow& row)
    : events_{events}, daemons_{daemons}, row_{row} {
  sweep_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<UnitFeed*>(self)->sweep();
        return 0;
      },
      this);
}

/// Whoever still asks is told while there is none that could be found.
UnitFeed::~UnitFeed() {
  const std::list<Subscription> last = std::exchange(all_, {});
}

/// Not where the last viewer leaves: its connection may be in the midst of telling something.
void UnitFeed::sweep() {
  std::erase_if(all_, [](const Subscription& each) { return each.viewers.is_empty() && each.asking.empty(); });
}

void UnitFeed::open(const std::shared_ptr<Exchange>& exchange, const json& params) {
  const auto known = std::ranges::find(all_, params, &Subscription::params);
  if (known != all_.end()) {
    if (known->viewers.size() + known->asking.size() >= kMostViewers)
      return exchange->answer(
          refuse(Refused::TooMany, fmt::format("{} viewers see the same already", kMostViewers)));
    if (known->is_granted) return let_in(*known, exchange);
    known->asking.push_back(exchange);
    return;
  }
  const auto subscription = subscribe(params);
  if (!subscription) return exchange->answer(subscription.error());
  (*subscription)->asking.push_back(exchange);
  DaemonClient& client = *(*subscription)->client;
  client.ask(row_.method, params, [this, &client](const Answer& answer) { take_answer(client, answer); });
}

tl::expected<UnitFeed::Subscription*, Error> UnitFeed::subscribe(const json& params) {
  const auto daemon = daemons_.find(params.at("unit").get_ref<const std::string&>());
  if (!daemon) return tl::unexpected{daemon.error()};
  const std::string& path = (*daemon)->path();
  const auto is_there = [&path](const Subscription& each) { return each.client->path() == path; };
  if (static_cast<std::size_t>(std::ranges::count_if(all_, is_there)) >= kMostSubscriptions)
    return tl::unexpected{
        refuse(Refused::TooMany,
               fmt::format("{} different streams of this kind are open at this daemon", kMostSubscriptions))};
  auto client = daemons_.connect(path, *this);
  if (!client) return tl::unexpected{refuse(Refused::NoDaemon, client.error())};
  return &all_.emplace_back(Subscription{params, *std::move(client)});
}

void UnitFeed::take_answer(DaemonClient& client, const Answer& answer) {
  Subscription* const subscription = find(client);
  if (subscription == nullptr) return;
  subscription->is_granted = answer.has_value();
  for (const std::shared_ptr<Exchange>& exchange : std::exchange(subscription->asking, {}))
    answer ? let_in(*subscription, exchange) : exchange->answer(answer.error());
  if (answer) return;
  subscription->params = nullptr;  // who asks for the same is not to be refused without being asked
  axisd::ServiceEvents::start(sweep_, std::chrono::microseconds{0});
}

void UnitFeed::let_in(Subscription& subscription, const std::shared_ptr<Exchange>& exchange) {
  const auto stream = subscription.viewers.add();
  stream->push(event_text(row_.greeting, json_text(subscription.params)));
  exchange->stream(stream, [this, stream] { remove(*stream); });
}

void UnitFeed::remove(const EventStream& stream) {
  for (Subscription& subscription : all_) subscription.viewers.remove(stream);
  axisd::ServiceEvents::start(sweep_, std::chrono::microseconds{0});
}

void UnitFeed::beat() {
  for (Subscription& subscription : all_) subscription.viewers.tell(heartbeat());
}

void UnitFeed::on_notice(DaemonClient& client, std::string_view key, const json& value) {
  on_notice_text(client, key, json_text(value));
}

/// It goes to the viewers as it has come.
bool UnitFeed::on_notice_text(DaemonClient& client, std::string_view key, std::string_view value) {
  Subscription* const subscription = find(client);
  if (subscription != nullptr && std::ranges::find(row_.notices, key) != row_.notices.end())
    subscription->viewers.tell(event_text(key, value));
  return true;
}

void UnitFeed::on_gone(DaemonClient& client, const std::string& why) {
  Subscription* const subscription = find(client);
  if (subscription == nullptr) return;
  subscription->viewers.end(event_text("ended", json_text({{"message", why}})));
  const auto is_it = [subscription](const Subscription& each) { return &each == subscription; };
  std::erase_if(all_, is_it);
}

UnitFeed::Subscription* UnitFeed::find(const DaemonClient& client) noexcept {
  const auto found = std::ranges::find(all_, &client, [](const Subscription& each) { return each.client.get(); });
  return found == all_.end() ? nullptr : &*found;
}

}  // namespace gateway
