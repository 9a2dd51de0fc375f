#pragma once

#include <cstdint>
#include <string>

#include "farm/agent/plan/orders.hpp"

namespace farm::agent {

/// Who is told what became of orders, and what runs already. Reasons are one line.
class Outcomes {
 public:
  Outcomes() = default;
  Outcomes(const Outcomes&) = delete;
  Outcomes& operator=(const Outcomes&) = delete;
  virtual ~Outcomes() = default;

  /// @p problem is empty if the configuration can be used.
  virtual void on_judged(const Check& check, const std::string& problem) = 0;
  /// It could not be judged, which says nothing of the configuration.
  virtual void on_not_judged(const Check& check, const std::string& why) = 0;
  /// A unit runs since before this agent.
  virtual void on_unit_found(const UnitStart& unit) = 0;
  virtual void on_unit_started(const UnitName& unit) = 0;
  virtual void on_unit_ended(const UnitName& unit, const std::string& why) = 0;
  /// Whether what @p unit has saved is on the server.
  virtual void on_saved(const UnitName& unit, bool is_saved) = 0;
  virtual void on_hub_found(const std::string& bus, std::uint32_t bit_rate) = 0;
  virtual void on_hub_started(const std::string& bus) = 0;
  virtual void on_hub_ended(const std::string& bus, const std::string& why) = 0;
  /// Something that people are to know.
  virtual void on_warning(const std::string& text) = 0;
};

}  // namespace farm::agent
