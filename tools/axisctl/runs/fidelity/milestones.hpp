#pragma once

#include <vector>

#include "tools/axisctl/runs/fidelity/time_map.hpp"

namespace runs {

/// Something that both the log and the run have.
struct Milestone {
  canopen::Duration log{}, run{};
  std::uint64_t place = 0;
  std::string what{};
};

/// By what a run is judged, and what comes of it.
struct Assessment {
  const Yardstick& yardstick;
  const Extents& extents;
  const TimeMap& times;  ///< from the log to the run
  Verdict& verdict;
  std::vector<Milestone>& milestones;
};

/// Judges whether @p milestones come in the same order; what is closer together than times may differ may change
/// places.
void judge_order(std::vector<Milestone> milestones, const TimeMap& times, Verdict& verdict);

}  // namespace runs
