#pragma once

#include <list>
#include <memory>
#include <vector>

#include "daemon/server/control_server.hpp"
#include "daemon/server/unit_job.hpp"
#include "daemon/watch/streams/frame_buffer.hpp"
#include "service/service_events.hpp"

namespace axisd {

/// Frames of units for clients of the control socket: a buffer a unit, which is emptied every 50 ms for all who
/// want its frames. A client has at most one subscription.
class FrameSubscriptions {
 public:
  using ClientId = ControlServer::ClientId;

  /// All arguments outlive it.
  FrameSubscriptions(ServiceEvents& events, ControlServer& server, const RunUnitJob& run) noexcept
      : events_{events}, server_{server}, run_{run} {}

  /// @p client is told the frames of @p unit; @p done gets the answer.
  void subscribe(ClientId client, ServedUnit& unit, std::function<void(Outcome)> done);
  void end(ClientId client);
  [[nodiscard]] bool has(ClientId client) const noexcept;
  /// @p unit has been switched on, and @p instance is about to be run.
  void take_up(const ServedUnit& unit, Instance& instance) noexcept;

 private:
  struct Feed {
    FrameSubscriptions* owner;
    ServedUnit* unit;
    std::shared_ptr<FrameBuffer> buffer;
    std::vector<ClientId> clients{};
    std::size_t asking = 0;  ///< clients that have no answer yet
    EventSource timer{};
  };

  static int on_period(sd_event_source* source, std::uint64_t now, void* feed) noexcept;
  void deliver(Feed& feed);
  Feed& feed_of(ServedUnit& unit);
  void end_unwanted();

  ServiceEvents& events_;
  ControlServer& server_;
  const RunUnitJob& run_;
  std::list<Feed> feeds_;
};

}  // namespace axisd
