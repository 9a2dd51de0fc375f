#pragma once

#include <string>
#include <vector>

#include "tools/axisctl/runs/fidelity/milestones.hpp"
#include "tools/axisctl/runs/fidelity/pdo_images.hpp"

namespace runs {

/// A TPDO as the log and the run have it.
struct PdoPair {
  const std::string& what;  ///< "TPDO 2 of node 5"
  const std::vector<PdoImage>& log;
  const std::vector<PdoImage>& run;
};

/// Judges the measured values of a TPDO: those of the log against what the run has about that time, and if there
/// is no difference, those of the run against what the log has, by the times of @p back.
void judge_values(const PdoPair& pdo, const TimeMap& back, const Assessment& assessment);

}  // namespace runs
