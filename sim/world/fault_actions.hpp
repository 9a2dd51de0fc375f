#pragma once

namespace sim {

class World;
struct FaultPlan;

/// @p fault happens in @p world.
void begin_fault(World& world, const FaultPlan& fault);
/// It is mended, or over; what a fault has done to a unit that was switched off since is gone with that.
void end_fault(World& world, const FaultPlan& fault);

}  // namespace sim
