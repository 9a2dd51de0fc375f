#pragma once

#include <functional>

#include "daemon/control/handler.hpp"
#include "daemon/fleet/served_unit.hpp"

namespace axisd {

/// Something to be done with a unit on its thread.
using UnitJob = std::function<Outcome(const Call& call)>;

/// Has @p job done with @p unit on the thread of that; @p done gets the outcome later, on the thread of the
/// control socket, or at once if the unit is switched off.
using RunUnitJob = std::function<void(ServedUnit& unit, UnitJob job, std::function<void(Outcome)> done)>;

}  // namespace axisd
