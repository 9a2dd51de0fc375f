#pragma once

#include <list>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "gateway/server/exchange.hpp"
#include "gateway/streams/viewers.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// Samples of signals. Viewers that ask for the same share one subscription, which has a connection of its own: a
/// daemon gives one subscription a client.
class SampleFeed final : private DaemonClient::Listener {
 public:
  /// Most subscriptions at a daemon, which has 64 clients at a time.
  static constexpr std::size_t kMostSubscriptions = 16;
  /// Most viewers of one of them.
  static constexpr std::size_t kMostViewers = 256;

  /// Both outlive it.
  SampleFeed(axisd::ServiceEvents& events, Daemons& daemons);
  SampleFeed(const SampleFeed&) = delete;
  SampleFeed& operator=(const SampleFeed&) = delete;
  ~SampleFeed() override;

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
  void on_gone(DaemonClient& client, const std::string& why) override;
  Subscription* find(const DaemonClient& client) noexcept;
  tl::expected<Subscription*, Error> subscribe(const nlohmann::json& params);
  void take_answer(DaemonClient& client, const Answer& answer);
  void let_in(Subscription& subscription, const std::shared_ptr<Exchange>& exchange);
  void remove(const EventStream& stream);
  void sweep();

  axisd::ServiceEvents& events_;
  Daemons& daemons_;
  std::list<Subscription> all_;
  axisd::EventSource sweep_;  ///< a timer
};

}  // namespace gateway
