#pragma once

#include <vector>

#include "tools/axisctl/runs/fidelity/milestones.hpp"

namespace runs {

/// Judges what the unit has answered over SDO, request by request: values, abort codes, times. Adds the answers
/// that both have to @p milestones.
void judge_answers(const Course& log, const Course& run, const Yardstick& yardstick, const Extents& extents,
                   const TimeMap& times, Verdict& verdict, std::vector<Milestone>& milestones);

/// Adds the measured values that answers of @p log tell to @p extents.
void note_answers(const Course& log, const Yardstick& yardstick, Extents& extents);

}  // namespace runs
