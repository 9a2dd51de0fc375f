#pragma once

#include <array>
#include <list>
#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "gateway/server/exchange.hpp"
#include "gateway/streams/viewers.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// What is told of one unit by a method of the control socket, and how viewers see it.
struct UnitFeedRow {
  std::string_view method;                  ///< that subscribes to it
  std::string_view greeting;                ///< first event of a stream: what was asked for
  std::array<std::string_view, 2> notices;  ///< keys of the lines, which are the names of the events
};
inline constexpr UnitFeedRow kSampleFeed{"samples.subscribe", "signals", {"sample", "samples"}};
inline constexpr UnitFeedRow kFrameFeed{"frames.subscribe", "unit", {"frames", ""}};

/// What is told of units: samples of signals, frames. Viewers that ask for the same share one subscription, which
/// has a connection of its own: a daemon gives one subscription a client.
class UnitFeed final : private DaemonClient::Listener {
 public:
  /// Most subscriptions at a daemon, which has 64 clients at a time.
  static constexpr std::size_t kMostSubscriptions = 16;
  /// Most viewers of one of them.
  static constexpr std::size_t kMostViewers = 256;

  /// Of what @p row says. The other arguments outlive it.
  UnitFeed(axisd::ServiceEvents& events, Daemons& daemons, const UnitFeedRow& row);
  UnitFeed(const UnitFeed&) = delete;
  UnitFeed& operator=(const UnitFeed&) = delete;
  ~UnitFeed() override;

  /// Answers @p exchange by a stream of what @p params, with `unit`, ask for, or by the daemon's refusal.
  void open(const std::shared_ptr<Exchange>& exchange, const nlohmann::json& params);
  /// Lets all viewers see that the connection lives.
  void beat();

 private:
  struct Subscription {
    nlohmann::json params;
    std::unique_ptr<DaemonClient> client;
    bool is_granted = false;
    std::list<std::shared_ptr<Exchange>> asking{};  ///< until it is granted
    Viewers viewers{};
  };

  void on_notice(DaemonClient& client, std::string_view key, const nlohmann::json& value) override;
  bool on_notice_text(DaemonClient& client, std::string_view key, std::string_view value) override;
  void on_gone(DaemonClient& client, const std::string& why) override;
  Subscription* find(const DaemonClient& client) noexcept;
  tl::expected<Subscription*, Error> subscribe(const nlohmann::json& params);
  void take_answer(DaemonClient& client, const Answer& answer);
  void let_in(Subscription& subscription, const std::shared_ptr<Exchange>& exchange);
  void remove(const EventStream& stream);
  void sweep();

  axisd::ServiceEvents& events_;
  Daemons& daemons_;
  UnitFeedRow row_;
  std::list<Subscription> all_;
  axisd::EventSource sweep_;  ///< a timer
};

}  // namespace gateway
