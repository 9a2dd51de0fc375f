#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "farm/agent/plan/times.hpp"
#include "farm/naming/unit_name.hpp"

namespace farm::agent {

/// A host that takes units.
struct Candidate {
  std::string host;
  std::uint32_t capacity = 1;
  std::uint32_t load = 0;  ///< units that are placed there
};

/// A unit that has no place.
struct OpenUnit {
  UnitName name;
  std::uint64_t order = 0;      ///< whose turn it is first: the lower one's
  std::set<std::string> hosts;  ///< of the candidates those where it may be
};

/// Whose turn it is to take which unit: that of the host with the most free capacity relative to what it has.
/// Every agent comes to the same, from the same candidates and units; what it has come to stays until the unit is
/// taken, so that the takings that come in one after the other do not change it. A host that lets its turn pass is
/// left out until all have.
class Placement {
 public:
  /// All units that have no place at @p now, and where they may go.
  void plan(std::vector<OpenUnit> open, std::vector<Candidate> candidates, canopen::TimePoint now);

  /// The host whose turn it is to take @p unit; empty: nobody's.
  [[nodiscard]] const std::string& host_for(const UnitName& unit) const;
  /// When the next turn is over; kNever without any.
  [[nodiscard]] canopen::TimePoint next_turn() const noexcept { return next_turn_; }

 private:
  struct Turn {
    std::string host;
    canopen::TimePoint until;
    std::set<std::string> passed;  ///< hosts that had a turn
  };

  std::map<UnitName, Turn> turns_;
  canopen::TimePoint next_turn_ = canopen::kNever;
};

}  // namespace farm::agent
