#include "daemon/server/subscriptions.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>

#include "control/protocol.hpp"
#include "daemon/control/handlers.hpp"
#include "record/event.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;
using Kinds = std::bitset<record::kEventKinds>;

/// Those that @p names name, all without any.
tl::expected<Kinds, control::Error> kinds_of(const json& params) {
  const auto names = params.find("kinds");
  if (names == params.end() || names->empty()) return Kinds{}.set();
  Kinds kinds;
  for (const json& name : *names) {
    const auto* const row = std::ranges::find_if(
        record::kEventRows, [&](const record::EventRow& known) { return name == known.name; });
    if (row == record::kEventRows.end())
      return refuse(ErrorCode::BadParameter,
                    fmt::format("kinds: expected kinds of events such as \"{}\" or \"{}\", got {}",
                                record::kEventRows.front().name, record::kEventRows.back().name, name.dump()));
    kinds.set(static_cast<std::size_t>(row->kind));
  }
  return kinds;
}

}  // namespace

Subscriptions::Subscriptions(ServiceEvents& events, Fleet& fleet, EventQueue& queue, ControlServer& server,
                             RunUnitJob run)
    : events_{events},
      fleet_{fleet},
      queue_{queue},
      server_{server},
      run_{std::move(run)},
      source_{events.watch(queue.descriptor(), EPOLLIN, &Subscriptions::on_events, this)} {}

Outcome Subscriptions::subscribe_to_events(ClientId client, ServedUnit* unit, const json& params) {
  const auto kinds = kinds_of(params);
  if (!kinds) return tl::unexpected{kinds.error()};
  filters_.remove_if([client](const EventFilter& filter) { return filter.client == client; });
  filters_.push_back({client, unit, *kinds});
  keep(client);
  watch_units();
  return json::object();
}

void Subscriptions::end_events(ClientId client) {
  const auto ended = filters_.remove_if([client](const EventFilter& filter) { return filter.client == client; });
  if (ended == 0) return;
  keep(client);
  watch_units();
}

void Subscriptions::subscribe_to_samples(ClientId client, ServedUnit& unit, const json& params,
                                         std::function<void(Outcome)> done) {
  if (!params.contains("batch_ms")) return poll(client, unit, params, std::move(done));
  batches_.subscribe(client, unit, params, [this, client, done = std::move(done)](Outcome outcome) {
    if (outcome) polls_.remove_if([client](const Poll& poll) { return poll.client == client; });
    keep(client);
    done(std::move(outcome));
  });
}

void Subscriptions::poll(ClientId client, ServedUnit& unit, const json& params,
                         std::function<void(Outcome)> done) {
  const json signals{{"signals", params.at("signals")}};
  const std::chrono::milliseconds period{params.at("period_ms").get<std::int64_t>()};
  read(unit, signals, [this, client, &unit, signals, period, done = std::move(done)](Outcome first) {
    if (!first || !server_.has(client)) return done(std::move(first));
    end_samples(client);
    Poll& poll = polls_.emplace_back(Poll{this, client, &unit, signals, period, nullptr});
    poll.timer = events_.timer(&Subscriptions::on_period, &poll);
    ServiceEvents::start(poll.timer, poll.period);
    keep(client);
    done(json::object());
    deliver_sample(client, first);
  });
}

void Subscriptions::read(ServedUnit& unit, const json& signals, std::function<void(Outcome)> done) {
  static const Handler& handler = *find_handler("signal.read");
  run_(
      unit, [signals](const Call& call) { return handler.answer(call, signals); }, std::move(done));
}

void Subscriptions::end_samples(ClientId client) {
  polls_.remove_if([client](const Poll& poll) { return poll.client == client; });
  batches_.end(client);
  keep(client);
}

void Subscriptions::subscribe_to_frames(ClientId client, ServedUnit& unit, std::function<void(Outcome)> done) {
  frames_.subscribe(client, unit, [this, client, done = std::move(done)](Outcome outcome) {
    keep(client);
    done(std::move(outcome));
  });
}

void Subscriptions::end_frames(ClientId client) {
  frames_.end(client);
  keep(client);
}

void Subscriptions::forget(ClientId client) {
  end_samples(client);
  end_frames(client);
  end_events(client);
}

void Subscriptions::take_up(const ServedUnit& unit, Instance& instance) {
  instance.tell_events(is_watched(unit));
  frames_.take_up(unit, instance);
  batches_.take_up(unit, instance);
}

bool Subscriptions::is_watched(const ServedUnit& unit) const noexcept {
  return std::ranges::any_of(
      filters_, [&unit](const EventFilter& filter) { return filter.unit == nullptr || filter.unit == &unit; });
}

/// Who has a subscription makes no room for others.
void Subscriptions::keep(ClientId client) {
  const bool has_filter = std::ranges::find(filters_, client, &EventFilter::client) != filters_.end();
  server_.keep(client, has_filter || poll_of(client) != nullptr || frames_.has(client) || batches_.has(client));
}

/// A unit to which nobody listens any more tells nothing.
void Subscriptions::watch_units() {
  for (ServedUnit& unit : fleet_.units()) {
    const bool wanted = is_watched(unit);
    if (watched_.contains(&unit) == wanted) continue;
    wanted ? static_cast<void>(watched_.insert(&unit)) : static_cast<void>(watched_.erase(&unit));
    Instance* const instance = unit.instance();
    if (instance != nullptr) unit.loop().post([instance, wanted] { instance->tell_events(wanted); });
  }
}

int Subscriptions::on_events(sd_event_source*, int, std::uint32_t, void* self) noexcept {
  static_cast<Subscriptions*>(self)->deliver_events();
  return 0;
}

void Subscriptions::deliver_events() {
  lost_ += queue_.take(taken_);
  for (const EventQueue::Entry& entry : taken_) deliver(entry);
}

void Subscriptions::deliver(const EventQueue::Entry& entry) {
  const ServedUnit& unit = fleet_.unit_of(*entry.unit);
  const auto wants = [&](const EventFilter& filter) {
    return (filter.unit == nullptr || filter.unit == &unit) &&
           filter.kinds.test(static_cast<std::size_t>(entry.event.kind));
  };
  std::vector<ClientId> clients;  // one that is cut off leaves the list
  for (const EventFilter& filter : filters_)
    if (wants(filter)) clients.push_back(filter.client);
  if (clients.empty()) return;
  json event = record::json_of(entry.event, entry.started);
  event["unit"] = unit.name();
  const std::string line = control::notice_line("event", event);
  for (const ClientId client : clients) server_.push(client, line);
}

Subscriptions::Poll* Subscriptions::poll_of(ClientId client) noexcept {
  const auto found = std::ranges::find(polls_, client, &Poll::client);
  return found == polls_.end() ? nullptr : &*found;
}

int Subscriptions::on_period(sd_event_source*, std::uint64_t, void* userdata) noexcept {
  auto& poll = *static_cast<Poll*>(userdata);
  ServiceEvents::start(poll.timer, poll.period);
  if (std::exchange(poll.is_asked, true)) return 0;  // a unit that is late is not asked again
  Subscriptions& self = *poll.owner;
  self.read(*poll.unit, poll.params, [&self, client = poll.client](const Outcome& outcome) {
    if (Poll* const asked = self.poll_of(client)) {
      asked->is_asked = false;
      self.deliver_sample(client, outcome);
    }
  });
  return 0;
}

/// Nothing while the unit is switched off.
void Subscriptions::deliver_sample(ClientId client, const Outcome& outcome) {
  const Poll* const poll = poll_of(client);
  if (!outcome || poll == nullptr) return;
  json values = json::array();
  for (const json& signal : outcome->at("signals")) values.push_back(signal.at("value"));
  server_.push(client, control::notice_line("sample", {{"unit", poll->unit->name()},
                                                       {"t", outcome->at("t")},
                                                       {"values", std::move(values)}}));
}

}  // namespace axisd
