#pragma once

#include <bitset>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "daemon/control/handler.hpp"
#include "daemon/fleet/fleet.hpp"
#include "daemon/server/control_server.hpp"
#include "daemon/server/event_queue.hpp"
#include "daemon/server/frame_subscriptions.hpp"
#include "daemon/server/sample_subscriptions.hpp"
#include "service/service_events.hpp"

namespace axisd {

/// What clients of the control socket are told without asking: events as they come, frames, and samples of signals
/// now and then. A client has at most one subscription of each; the next one takes its place.
class Subscriptions {
 public:
  using ClientId = ControlServer::ClientId;
  /// All arguments outlive it.
  Subscriptions(ServiceEvents& events, Fleet& fleet, EventQueue& queue, ControlServer& server, RunUnitJob run);

  /// @p client is told the events of @p unit, or of all units; `kinds` of @p params says which.
  Outcome subscribe_to_events(ClientId client, ServedUnit* unit, const nlohmann::json& params);
  void end_events(ClientId client);
  /// @p client is told what `signals` of @p params are in @p unit every `period_ms`, with `batch_ms` in lines of
  /// several; @p done gets the answer.
  void subscribe_to_samples(ClientId client, ServedUnit& unit, const nlohmann::json& params,
                            std::function<void(Outcome)> done);
  void end_samples(ClientId client);
  /// @p client is told the frames of @p unit; @p done gets the answer.
  void subscribe_to_frames(ClientId client, ServedUnit& unit, std::function<void(Outcome)> done);
  void end_frames(ClientId client);
  /// @p client is gone.
  void forget(ClientId client);
  /// @p unit has been switched on, and @p instance is about to be run: what is wanted of it.
  void take_up(const ServedUnit& unit, Instance& instance);

  /// Events that were lost because they came faster than they were taken.
  std::uint64_t lost_events() const noexcept { return lost_; }

 private:
  struct EventFilter {
    ClientId client{};
    const ServedUnit* unit = nullptr;  ///< nullptr: all
    std::bitset<record::kEventKinds> kinds;
  };
  /// Samples of a client, which the unit is asked for one by one.
  struct Poll {
    Subscriptions* owner;
    ClientId client;
    ServedUnit* unit;
    nlohmann::json params;
    std::chrono::microseconds period;
    EventSource timer;
    bool is_asked = false;  ///< the unit has not answered yet
  };

  static int on_events(sd_event_source* source, int descriptor, std::uint32_t events, void* self) noexcept;
  static int on_period(sd_event_source* source, std::uint64_t now, void* poll) noexcept;
  void deliver_events();
  void deliver(const EventQueue::Entry& entry);
  void deliver_sample(ClientId client, const Outcome& outcome);
  void keep(ClientId client);
  void poll(ClientId client, ServedUnit& unit, const nlohmann::json& params, std::function<void(Outcome)> done);
  void read(ServedUnit& unit, const nlohmann::json& signals, std::function<void(Outcome)> done);
  bool is_watched(const ServedUnit& unit) const noexcept;
  void watch_units();
  Poll* poll_of(ClientId client) noexcept;

  ServiceEvents& events_;
  Fleet& fleet_;
  EventQueue& queue_;
  ControlServer& server_;
  RunUnitJob run_;
  FrameSubscriptions frames_{events_, server_, run_};
  SampleSubscriptions batches_{events_, server_, run_};
  EventSource source_;
  std::list<EventFilter> filters_;
  std::list<Poll> polls_;
  std::vector<EventQueue::Entry> taken_;
  std::unordered_set<const ServedUnit*> watched_;
  std::uint64_t lost_ = 0;
};

}  // namespace axisd
