// The switches beside the ways of the loads, which feed the digital inputs of the unit.
#include "drive/drive_unit.hpp"

namespace drive {

void DriveUnit::fit_switches() {
  for (const Axis& axis : axes_) {
    const TravelSwitchList& switches = axis.context().axis.switches;
    if (switches.count > 0) switches_.push_back({&axis, TravelSwitches{switches}});
  }
  move_switches();
}

/// A slice of time has passed: the digital inputs follow the switches that the loads have come past.
void DriveUnit::move_switches() noexcept {
  if (switches_.empty()) return;
  InputEdges moved{};
  Terminals::Word fed = 0;
  for (AxisSwitches& axis : switches_) {
    axis.switches.move(axis.axis->load_place(), moved);
    fed |= axis.switches.inputs();
  }
  control_unit_.terminals().pass_slice(moved, fed);
}

}  // namespace drive
