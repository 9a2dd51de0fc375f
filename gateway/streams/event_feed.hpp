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

  /// An event of some unit.
  struct Told {
    std::uint64_t id;  ///< that of the stream
    const std::string& unit;
    const std::string& kind;
    const nlohmann::json& event;
  };
  /// Who is told all events beside the viewers.
  class Follower {
   public:
    virtual ~Follower() = default;
    virtual void on_event(const Told& told) = 0;
  };

  /// @p daemons outlives it, and tells it alone.
  explicit EventFeed(Daemons& daemons);
  EventFeed(const EventFeed&) = delete;
  EventFeed& operator=(const EventFeed&) = delete;
  ~EventFeed() override { daemons_.listen(nullptr); }

  /// Answers @p exchange by a stream of the events that @p query asks for: `unit` and `kinds`, each a list.
  void open(const std::shared_ptr<Exchange>& exchange, const Query& query);
  /// Tells @p follower from now on, nullptr: nobody. Gives a number that lies between those of the events before
  /// and behind.
  std::uint64_t follow(Follower* follower);
  /// The number of the last event.
  [[nodiscard]] std::uint64_t last_id() const noexcept { return last_id_; }
  /// Lets all viewers see that the connection lives.
  void beat() { viewers_.tell(heartbeat()); }

 private:
  void on_event(const nlohmann::json& event) override;
  void on_units() override;
  [[nodiscard]] EventText units_text() const;
  /// Lets the daemons tell their events while anybody wants them.
  void ask_daemons();

  Daemons& daemons_;
  Viewers viewers_;
  Follower* follower_ = nullptr;
  std::uint64_t last_id_;
};

}  // namespace gateway
