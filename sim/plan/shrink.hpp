#pragma once

#include <functional>

#include "sim/plan/world_plan.hpp"

namespace sim {

/// A plan that fails as @p plan does, with as little in it as can be found: faults, units, axes and habits of
/// masters are left out one by one as long as @p fails is true of what is left. @p fails is true of @p plan.
WorldPlan shrink(WorldPlan plan, const std::function<bool(const WorldPlan&)>& fails);

}  // namespace sim
