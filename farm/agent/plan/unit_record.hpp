#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "farm/agent/plan/process.hpp"
#include "farm/documents/place.hpp"
#include "farm/documents/wanted_unit.hpp"

namespace farm::agent {

/// A document of the bucket of units.
struct Wish {
  std::string text;            ///< as it was told
  std::uint64_t revision = 0;  ///< the lower it is, the earlier the unit was wanted so
  WantedUnit content;          ///< as far as it can be read
  std::string configuration;   ///< of it, JSON
  std::string problem;         ///< why it cannot be read; empty: it can
};

/// A place as it was told or written.
struct KnownPlace {
  Place place;
  std::uint64_t revision = 0;  ///< 0: there is none, or not yet again
};

/// What a configuration came to when it was judged.
struct Judgement {
  std::string configuration;
  std::string problem;                         ///< empty: it can be used
  canopen::TimePoint again = canopen::kNever;  ///< when it is to be judged again: it could not be
};

/// All that is known of one unit.
struct UnitRecord {
  std::optional<Wish> wish;
  std::optional<KnownPlace> known;  ///< nothing: there was never a place

  Process process;
  std::string running;     ///< configuration of the process
  std::uint64_t term = 0;  ///< of the place under which it was started, as it is kept beside its state; 0: unknown
  std::string generation;  ///< likewise: of the buckets
  bool is_saved = true;    ///< what the unit has saved is on the server

  std::optional<Judgement> judgement;
  bool is_being_judged = false;

  bool is_being_written = false;     ///< its place
  canopen::TimePoint write_again{};  ///< before that no further attempt is made

  canopen::TimePoint there_since = canopen::kNever;  ///< a door says that it is there though no agent has it
  std::string told_problem;                          ///< the last one that people were told

  /// Of the place; 0 if there was none.
  [[nodiscard]] std::uint64_t last_term() const noexcept { return known ? known->place.term : 0; }
  [[nodiscard]] bool is_at(std::string_view host) const noexcept { return known && known->place.host == host; }
  /// Whether the present wish was judged, and can be used.
  [[nodiscard]] bool is_good() const noexcept {
    return wish && wish->problem.empty() && judgement && judgement->configuration == wish->configuration &&
           judgement->problem.empty();
  }
};

}  // namespace farm::agent
