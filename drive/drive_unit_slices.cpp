// The slices of 1 ms: switches beside the ways of the loads, which feed the digital inputs of the unit, and
// position control.
#include <algorithm>
#include <cmath>

#include "drive/drive_unit.hpp"
#include "drive/wiring.hpp"

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
  InputEdges moved{};
  Terminals::Word fed = 0;
  for (AxisSwitches& axis : switches_) {
    axis.switches.move(axis.axis->load_place(), moved);
    fed |= axis.switches.inputs();
  }
  control_unit_.terminals().pass_slice(moved, fed);
}

/// The axes go through the phases of a slice side by side, each with the inputs as they are then.
void DriveUnit::run_slice(const Running& running) noexcept {
  move_switches();
  const auto axes = running.all();
  for (Axis* const axis : axes)
    if (axis->positions()) axis->begin_slice(control_unit_.terminals().edges());
  for (const Phase phase : kInTheSlices)
    for (Axis* const axis : axes) {
      if (!axis->positions()) continue;
      take_inputs(*axis, phase);
      axis->run(phase);
    }
  for (Axis* const axis : axes) {
    if (!axis->positions()) continue;
    wiring_->take(*axis, kBlock<SpeedSetpoint2>);
    axis->follow_position();
  }
}

/// Where an axis has position control, or switches are beside its way, slices of 1 ms begin among the steps.
void DriveUnit::move(const Running& running, double duration) noexcept {
  const long steps = std::lround(duration / motor::kControlPeriod);
  lowest_dc_voltage_ = dc_link_.voltage();
  const bool sliced = !switches_.empty() || std::ranges::any_of(running.all(), &Axis::positions);
  if (observer_ == nullptr && !sliced) [[likely]]
    return run_steps(running.all(), steps);
  for (long step = 0; step < steps;) {
    if (sliced && steps_in_slice_ == 0) run_slice(running);
    const long until_slice = sliced ? std::min(steps - step, kStepsInASlice - steps_in_slice_) : steps;
    const long count = observer_ != nullptr ? 1 : until_slice;
    run_steps(running.all(), count);
    step += count;
    if (sliced) steps_in_slice_ = (steps_in_slice_ + count) % kStepsInASlice;
    if (observer_ != nullptr && step < steps) observer_->on_step(step);
  }
}

}  // namespace drive
