#pragma once

#include <deque>
#include <memory>
#include <string>

#include "gateway/live/live_feeds.hpp"
#include "gateway/streams/event_feed.hpp"

namespace gateway {

/// The last events of all units, for those who ask again and again. They are kept while somebody asks, by the
/// subscription that the streams of events have.
class RecentEvents final : private EventFeed::Follower {
 public:
  /// So many are kept; the oldest go first.
  static constexpr std::size_t kMostEvents = 2000;
  /// If nobody has asked for so long, nothing is kept any more.
  static constexpr LiveTime kPatience{60'000};

  /// All outlive it; @p clock tells since when nobody has asked.
  RecentEvents(axisd::ServiceEvents& events, const Daemons& daemons, EventFeed& feed, LiveClock clock = live_time);
  RecentEvents(const RecentEvents&) = delete;
  RecentEvents& operator=(const RecentEvents&) = delete;
  ~RecentEvents() override;

  /// The events that @p query asks for, `unit` and `kinds`, and which follow the one called `after` in @p params,
  /// the same query; all that are kept if that is not there.
  [[nodiscard]] Response answer(const Query& query, const nlohmann::json& params);
  /// Ends if nobody asks any more; it is called each second.
  void sweep();
  /// Whether events are kept.
  [[nodiscard]] bool is_keeping() const noexcept { return first_ != 0; }

 private:
  struct Event {
    std::uint64_t id;
    std::string unit;
    std::string kind;
    std::string text;
  };

  void on_event(const EventFeed::Told& told) override;
  /// Keeps events from now on.
  void begin();

  const Daemons& daemons_;
  EventFeed& feed_;
  LiveClock clock_;
  std::deque<Event> kept_;
  std::uint64_t first_ = 0;  ///< the number before which nothing was kept; 0: nothing is
  LiveTime asked_{};
  axisd::EventSource sweep_;  ///< a timer
};

}  // namespace gateway
