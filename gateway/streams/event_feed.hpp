#pragma once

#include <cstdint>
#include <memory>

#include "gateway/routes/arguments.hpp"
#include "gateway/server/exchange.hpp"
#include "gateway/streams/viewers.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// The events of all units, for any number of viewers by one subscription a daemon.
class EventFeed final : private Daemons::Listener {
 public:
  /// Most viewers at a time.
  static constexpr std::size_t kMostViewers = 512;

  /// @p daemons outlives it, and tells it alone.
  explicit EventFeed(Daemons& daemons);
  EventFeed(const EventFeed&) = delete;
  EventFeed& operator=(const EventFeed&) = delete;
  ~EventFeed() override { daemons_.listen(nullptr); }

  /// Answers @p exchange by a stream of the events that @p query asks for: `unit` and `kinds`, each a list.
  void open(const std::shared_ptr<Exchange>& exchange, const Query& query);
  /// Lets all viewers see that the connection lives.
  void beat() { viewers_.tell(heartbeat()); }

 private:
  void on_event(const nlohmann::json& event) override;
  void on_units() override;
  [[nodiscard]] EventText units_text() const;

  Daemons& daemons_;
  Viewers viewers_;
  std::uint64_t last_id_ = 0;
};

}  // namespace gateway
