#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "farm/documents/agent_beat.hpp"
#include "farm/link/messages.hpp"
#include "farm/mirror/mirror_times.hpp"
#include "farm/mirror/settling.hpp"
#include "service/service_events.hpp"

namespace farm {

/// Asks the agents of a farm who they are.
class AgentRoll {
 public:
  using OnAll = std::function<void(std::vector<AgentBeat>)>;

  /// @p events and @p messages outlive it.
  AgentRoll(axisd::ServiceEvents& events, Messages& messages, std::string farm, const MirrorTimes& times);
  AgentRoll(const AgentRoll&) = delete;
  AgentRoll& operator=(const AgentRoll&) = delete;
  ~AgentRoll();

  /// Tells @p on_all who has answered, in the order of the hosts, when it is likely that all have. One call at a
  /// time.
  void call(OnAll on_all);

 private:
  void take(const Message& message);
  void look();

  Messages& messages_;
  std::string farm_;
  Settling settling_;
  std::map<std::string, AgentBeat> heard_;
  OnAll on_all_;
  axisd::EventSource timer_;
};

}  // namespace farm
