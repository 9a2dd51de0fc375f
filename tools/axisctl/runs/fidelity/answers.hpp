#pragma once

#include <vector>

#include "tools/axisctl/runs/fidelity/milestones.hpp"

namespace runs {

/// Judges what the unit has answered over SDO, request by request: values, abort codes, times. The answers that
/// both have are milestones.
void judge_answers(const Course& log, const Course& run, const Assessment& assessment);

/// Adds the measured values that answers of @p log tell to @p extents.
void note_answers(const Course& log, const Yardstick& yardstick, Extents& extents);

}  // namespace runs
