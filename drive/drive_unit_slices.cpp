// The steps of 125 µs, and the slices of 1 ms among them: switches beside the ways of the loads, which feed the
// digital inputs of the unit, and position control.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "drive/axis/axis_step.hpp"
#include "drive/drive_unit.hpp"
#include "drive/wiring.hpp"
#include "motor/lockstep/lockstep.hpp"

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

/// Steps of a cycle, side by side on the DC link. At one place, for all of a step to be compiled into it.
void DriveUnit::run_steps(std::span<Axis* const> moved, long steps) noexcept {
  const bool one_by_one = std::ranges::any_of(moved, [](const Axis* axis) { return axis->goes_step_by_step(); });
  const long most = one_by_one ? 1 : static_cast<long>(kMostPlannedSteps);
  const double overvoltage = moved.empty() ? 0.0 : moved.front()->block<PowerUnit>().overvoltage();
  std::array<StepPlan, kMostAxes> plans;
  std::array<motor::AxisRun, kMostAxes> runs;
  for (long done = 0; done < steps;) {
    const long count = std::min(steps - done, most);
    for (std::size_t i = 0; i < moved.size(); ++i)
      runs[i] = moved[i]->plan_steps(plans[i], static_cast<std::size_t>(count));
    const motor::RunResult result = motor::run(std::span{runs}.first(moved.size()), dc_link_, count, overvoltage);
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i]->take_steps(plans[i], result);
    lowest_dc_voltage_ = std::min(lowest_dc_voltage_, result.lowest_dc_voltage);
    done += result.periods;
  }
  lowest_dc_voltage_ = std::min(lowest_dc_voltage_, dc_link_.voltage());
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
