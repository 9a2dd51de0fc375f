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

/// Judges whether @p milestones come in the same order; what is closer together than times may differ may change
/// places.
void judge_order(std::vector<Milestone> milestones, const TimeMap& times, Verdict& verdict);

}  // namespace runs
