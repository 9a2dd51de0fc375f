#pragma once

#include <cstdint>
#include <string>

#include "farm/agent/plan/orders.hpp"

namespace farm::agent {

/// Under what a unit has run on this host last, as it is kept beside what it has saved.
struct KeptState {
  std::uint64_t term = 0;  ///< of its place; 0: it never has
  std::string generation;  ///< of the buckets

  friend bool operator==(const KeptState&, const KeptState&) = default;

  /// Whether nobody else has run the unit since, if it is now to be started as @p start says: what it has saved
  /// here is the newest. Otherwise that is what lies on the server, if there is anything.
  [[nodiscard]] bool is_newest_for(const UnitStart& start) const noexcept {
    return term != 0 && generation == start.generation && (term == start.term || term + 1 == start.term);
  }
};

}  // namespace farm::agent
