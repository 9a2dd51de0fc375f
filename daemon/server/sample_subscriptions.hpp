#pragma once

#include <list>
#include <memory>

#include "daemon/server/control_server.hpp"
#include "daemon/server/unit_job.hpp"
#include "daemon/watch/streams/sample_buffer.hpp"
#include "service/service_events.hpp"

namespace axisd {

/// Samples of signals for clients of the control socket that want them in lines of several: the unit takes them
/// itself, at exact times. A client has at most one subscription, and each has a buffer of its own.
class SampleSubscriptions {
 public:
  using ClientId = ControlServer::ClientId;

  /// All arguments outlive it.
  SampleSubscriptions(ServiceEvents& events, ControlServer& server, const RunUnitJob& run) noexcept
      : events_{events}, server_{server}, run_{run} {}

  /// @p client is told what `signals` of @p params are in @p unit every `period_ms`, in a line each `batch_ms`;
  /// @p done gets the answer.
  void subscribe(ClientId client, ServedUnit& unit, const nlohmann::json& params,
                 std::function<void(Outcome)> done);
  void end(ClientId client);
  [[nodiscard]] bool has(ClientId client) const noexcept;
  /// @p unit has been switched on, and @p instance is about to be run.
  void take_up(const ServedUnit& unit, Instance& instance);

 private:
  struct Feed {
    SampleSubscriptions* owner;
    ClientId client;
    ServedUnit* unit;
    std::shared_ptr<SampleBuffer> buffer;
    std::chrono::milliseconds period;  ///< of the lines
    EventSource timer{};
  };

  static int on_period(sd_event_source* source, std::uint64_t now, void* feed) noexcept;
  void begin(Feed feed);
  void stop(ServedUnit& unit, const std::shared_ptr<SampleBuffer>& buffer);

  ServiceEvents& events_;
  ControlServer& server_;
  const RunUnitJob& run_;
  std::list<Feed> feeds_;
};

}  // namespace axisd
