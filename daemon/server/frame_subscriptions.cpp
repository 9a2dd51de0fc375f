#include "daemon/server/frame_subscriptions.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "daemon/server/stream_lines.hpp"

namespace axisd {
namespace {

constexpr std::chrono::milliseconds kPeriod{50};

}  // namespace

void FrameSubscriptions::subscribe(ClientId client, ServedUnit& unit, std::function<void(Outcome)> done) {
  Feed& feed = feed_of(unit);
  ++feed.asking;
  const auto begin = [buffer = feed.buffer](const Call& call) -> Outcome {
    if (call.instance.frame_stream().begin(buffer)) return nlohmann::json::object();
    return refuse(control::ErrorCode::Busy, "too many listen to the frames of the unit");
  };
  run_(unit, begin, [this, client, &feed, done = std::move(done)](Outcome outcome) {
    if (outcome && server_.has(client)) {
      end(client);
      feed.clients.push_back(client);
    }
    --feed.asking;
    end_unwanted();
    done(std::move(outcome));
  });
}

FrameSubscriptions::Feed& FrameSubscriptions::feed_of(ServedUnit& unit) {
  const auto known = std::ranges::find(feeds_, &unit, &Feed::unit);
  if (known != feeds_.end()) return *known;
  Feed& feed = feeds_.emplace_back(Feed{this, &unit, std::make_shared<FrameBuffer>()});
  feed.timer = events_.timer(&FrameSubscriptions::on_period, &feed);
  ServiceEvents::start(feed.timer, kPeriod);
  return feed;
}

void FrameSubscriptions::end(ClientId client) {
  for (Feed& feed : feeds_) std::erase(feed.clients, client);
  end_unwanted();
}

/// A unit whose frames nobody wants any more tells none.
void FrameSubscriptions::end_unwanted() {
  for (auto feed = feeds_.begin(); feed != feeds_.end();) {
    if (feed->asking != 0 || !feed->clients.empty()) {
      ++feed;
      continue;
    }
    const auto end = [](const Call& call) -> Outcome {
      call.instance.frame_stream().end();
      return nlohmann::json::object();
    };
    run_(*feed->unit, end, [](const Outcome&) {});
    feed = feeds_.erase(feed);
  }
}

bool FrameSubscriptions::has(ClientId client) const noexcept {
  return std::ranges::any_of(feeds_,
                             [client](const Feed& feed) { return std::ranges::count(feed.clients, client) != 0; });
}

void FrameSubscriptions::take_up(const ServedUnit& unit, Instance& instance) noexcept {
  const auto known = std::ranges::find(feeds_, &unit, &Feed::unit);
  if (known != feeds_.end()) static_cast<void>(instance.frame_stream().begin(known->buffer));
}

int FrameSubscriptions::on_period(sd_event_source*, std::uint64_t, void* feed) noexcept {
  auto& present = *static_cast<Feed*>(feed);
  present.owner->deliver(present);
  return 0;
}

/// A client that is cut off leaves the list, and the last one takes the feed with it.
void FrameSubscriptions::deliver(Feed& feed) {
  ServiceEvents::start(feed.timer, kPeriod);
  const std::vector<ClientId> clients = feed.clients;
  for (const std::string& line : frame_lines(feed.unit->name(), *feed.buffer))
    for (const ClientId client : clients) server_.push(client, line);
}

}  // namespace axisd
