#pragma once

#include <vector>

#include "tools/axisctl/page/page.hpp"
#include "tools/axisctl/scenario/run/stations.hpp"

namespace scenario {

/// What there is of all units at the end of a run: what they answer, and what they have recorded, which they no
/// longer do. Of a unit that does not answer, the files.
[[nodiscard]] std::vector<axisctl::PageUnit> capture(Stations& stations, const Scenario& scenario,
                                                     const Workshop& workshop);

}  // namespace scenario
