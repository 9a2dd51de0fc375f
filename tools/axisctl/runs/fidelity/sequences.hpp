#pragma once

#include <vector>

#include "tools/axisctl/runs/fidelity/milestones.hpp"

namespace runs {

/// Something that a unit has said by itself.
struct Event {
  canopen::Duration at{};
  std::uint64_t place = 0;
  std::vector<std::uint8_t> bytes{};  ///< what counts of it
  std::string words{};
};

/// Events of one kind from one source: in the log and in the run.
struct Sequence {
  Aspect aspect = Aspect::Emergency;
  std::string what{};
  std::optional<canopen::sdo::Address> object{};  ///< if it tells one object alone
  std::vector<Event> log{}, run{};
};

/// Judges the events of @p sequence one by one, with their times; those that both have are milestones.
/// What the run has more behind @p end does not count.
void judge_sequence(const Sequence& sequence, canopen::Duration end, bool has_times, const Assessment& assessment);

}  // namespace runs
