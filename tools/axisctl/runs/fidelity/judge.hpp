#pragma once

#include "tools/axisctl/runs/fidelity/verdict.hpp"
#include "tools/axisctl/runs/replay/course.hpp"

namespace runs {

/// Judges @p run, what a unit has said to the master of @p log, by what is in the log.
[[nodiscard]] Fidelity judge(const Course& log, const Course& run, const Yardstick& yardstick);

}  // namespace runs
