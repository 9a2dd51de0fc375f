#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "farm/agent/plan/times.hpp"
#include "farm/documents/agent_beat.hpp"
#include "farm/documents/door_beat.hpp"

namespace farm::agent {

/// Who is there, by what agents and doors tell.
class Presence {
 public:
  /// It is listened from @p now on: silence before means nothing.
  void listen(canopen::TimePoint now) { listening_since_ = now; }
  void on_agent(const AgentBeat& beat, canopen::TimePoint now);
  void on_door(const DoorBeat& beat, canopen::TimePoint now);

  /// The agents that were heard lately, one a host: that of several with the lowest instance.
  [[nodiscard]] std::vector<AgentBeat> agents(canopen::TimePoint now) const;
  /// Whether an agent of @p host was heard lately.
  [[nodiscard]] bool has_agent(const std::string& host, canopen::TimePoint now) const;
  /// The lowest instance of @p host that was heard lately, below @p instance.
  [[nodiscard]] std::optional<std::uint64_t> rival(const std::string& host, std::uint64_t instance,
                                                   canopen::TimePoint now) const;
  /// Whether others may take @p unit from @p host: its agent is silent, and so is its door, or says all the time
  /// that the unit is not there.
  [[nodiscard]] bool is_lost(const std::string& host, const UnitName& unit, canopen::TimePoint now) const;
  /// A host whose door says that @p unit is there.
  [[nodiscard]] std::optional<std::string> host_with(const UnitName& unit, canopen::TimePoint now) const;
  /// The next time after @p now at which somebody who tells nothing more is silent; kNever without any.
  [[nodiscard]] canopen::TimePoint next_silence(canopen::TimePoint now) const;

 private:
  struct Agent {
    AgentBeat beat;
    canopen::TimePoint heard;
  };
  struct Door {
    std::vector<std::set<UnitName>> parts;
    std::map<UnitName, canopen::TimePoint> said;  ///< when the door has said last that a unit is there
    canopen::TimePoint heard;
  };
  template <class Value>
  using ByInstance = std::map<std::uint64_t, Value>;

  [[nodiscard]] const Agent* agent_of(const std::string& host, canopen::TimePoint now) const;
  [[nodiscard]] bool is_silent(canopen::TimePoint heard, canopen::TimePoint now) const;

  canopen::TimePoint listening_since_{};
  std::map<std::string, ByInstance<Agent>> agents_;
  std::map<std::string, ByInstance<Door>> doors_;
};

}  // namespace farm::agent
