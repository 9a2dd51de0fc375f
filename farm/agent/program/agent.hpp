#pragma once

#include <string>
#include <vector>

#include "farm/agent/host/checks.hpp"
#include "farm/agent/host/hub_programs.hpp"
#include "farm/agent/host/outcomes.hpp"
#include "farm/agent/host/stored_state.hpp"
#include "farm/agent/host/unit_programs.hpp"
#include "farm/agent/plan/plan.hpp"
#include "farm/link/link.hpp"
#include "farm/naming/farm_url.hpp"
#include "service/log.hpp"

namespace farm::agent {

/// What an agent is to do.
struct Assignment {
  FarmUrl farm;
  Self self;
  Folders folders;
  UnitCommand units;
  HubCommand hubs;
};

/// An agent: the plan, with the server on one side and the programs of the host on the other.
class Agent final : public Link::Listener, public Outcomes {
 public:
  /// Finds what runs already, and begins to connect. What is passed by reference outlives this. Throws
  /// std::system_error.
  Agent(axisd::ServiceEvents& events, const Assignment& assignment, const axisd::Log& log);

  /// Does what is to be done. To be called when events have been handled, and at due().
  void advance();
  [[nodiscard]] canopen::TimePoint due() const noexcept;

  /// Gives all units away, and takes none.
  void drain();
  /// Nothing runs here and nothing is placed here.
  [[nodiscard]] bool is_empty() const { return plan_.is_empty(); }

  void on_up() override;
  void on_down(const std::string& why) override;

  void on_judged(const Check& check, const std::string& problem) override;
  void on_not_judged(const Check& check, const std::string& why) override;
  void on_unit_found(const UnitStart& unit) override;
  void on_unit_started(const UnitName& unit) override;
  void on_unit_ended(const UnitName& unit, const std::string& why) override;
  void on_saved(const UnitName& unit, bool is_saved) override;
  void on_hub_found(const std::string& bus, std::uint32_t bit_rate) override;
  void on_hub_started(const std::string& bus) override;
  void on_hub_ended(const std::string& bus, const std::string& why) override;
  void on_warning(const std::string& text) override;

 private:
  void watch(Bucket bucket, const std::string& name);
  void listen();
  void carry_out(const Orders& orders);
  void write(const PlaceWrite& place);
  void write(const DocumentWrite& document);
  void tell_all();
  void beat();
  [[nodiscard]] std::string bucket_name(Bucket bucket) const;

  const std::string farm_;
  const std::string host_;
  const Folders folders_;
  const axisd::Log& log_;
  Plan plan_;
  bool is_due_ = true;  ///< something was told that advance() has not seen
  AgentBeat told_;      ///< the last beat
  axisd::EventSource beat_;
  Checks checks_;
  StoredState state_;
  HubPrograms hubs_;
  UnitPrograms units_;
  Link link_;  ///< last: whoever waits is told when it goes
};

}  // namespace farm::agent
