#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "farm/door/service/host_claim.hpp"
#include "farm/door/service/outlets.hpp"
#include "farm/door/service/roster.hpp"
#include "farm/door/service/rpc.hpp"
#include "farm/door/service/service_info.hpp"
#include "farm/door/service/status_round.hpp"
#include "farm/link/messages.hpp"
#include "gateway/units/daemons.hpp"
#include "service/log.hpp"
#include "service/service_events.hpp"

namespace farm {

/// The units of a machine on a farm: requests go in, events, status and who is there go out.
class Door final : private gateway::Daemons::Listener {
 public:
  /// How it is called, and what it lets in.
  struct Settings {
    std::string farm;
    std::string host;
    bool read_only = false;
  };
  /// With whom it works; all of them outlive it.
  struct Parts {
    axisd::ServiceEvents& events;
    Messages& messages;
    gateway::Daemons& daemons;
    const axisd::Log& log;
  };

  Door(const Parts& parts, Settings settings);
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;
  ~Door() override;

  /// There is a connection to the server anew.
  void on_up();

 private:
  void on_event(const nlohmann::json& event) override;
  void on_units() override;

  /// The units.
  void ask_for_units();
  void ask_for_units(gateway::DaemonClient& daemon);
  void take_units(const std::string& path, const gateway::Answer& answer);
  void follow_units();
  /// Whether the name of the host is its own.
  void hear_door(const Message& message);
  void look_at_claim();
  [[nodiscard]] bool is_ready() const;
  void open();
  void close();
  /// The time.
  void step();
  void beat_soon();
  void beat();

  Parts parts_;
  Settings settings_;
  std::uint64_t instance_;
  ServiceInfo service_;
  HostClaim claim_;
  Roster roster_;
  Outlets outlets_;
  Rpc rpc_;
  StatusRound statuses_;
  std::set<UnitName> served_;    ///< units whose requests come here
  std::set<std::string> asked_;  ///< daemons, by their paths, that owe a list of their units
  bool is_told_taken_ = false;
  /// How often a beat was wanted since the last step.
  enum class Wanted : std::uint8_t { Never, Once, Again };
  Wanted wanted_ = Wanted::Never;
  std::size_t steps_ = 0;     ///< of kSteps a second
  std::size_t steps_up_ = 0;  ///< with a connection
  axisd::EventSource timer_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace farm
