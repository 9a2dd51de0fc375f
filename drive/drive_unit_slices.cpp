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
void DriveUnit::run_slice() noexcept {
  move_switches();
  const auto axes = running_.all();
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

/// The next @p steps (1..kMostPlannedSteps) of @p units, side by side, or fewer of them; how many. At one place,
/// for all of a step to be compiled into it.
long DriveUnit::run_steps(std::span<DriveUnit* const> units, long steps) noexcept {
  std::array<StepPlan, motor::kMostAxesInLockstep> plans;
  std::array<motor::AxisRun, motor::kMostAxesInLockstep> runs;
  std::array<motor::LinkedAxes, motor::kMostAxesInLockstep> links;
  std::size_t planned = 0;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const auto moved = units[i]->running_.all();
    const double overvoltage = moved.empty() ? 0.0 : moved.front()->block<PowerUnit>().overvoltage();
    links[i] = {{&runs[planned], moved.size()}, &units[i]->dc_link_, overvoltage};
    for (Axis* const axis : moved) {
      runs[planned] = axis->plan_steps(plans[planned], static_cast<std::size_t>(steps));
      ++planned;
    }
  }
  const long done = motor::run_together(std::span{links}.first(units.size()), steps);
  planned = 0;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const motor::RunResult& result = links[i].result;
    for (Axis* const axis : units[i]->running_.all()) axis->take_steps(plans[planned++], result);
    units[i]->lowest_dc_voltage_ = std::min(units[i]->lowest_dc_voltage_, result.lowest_dc_voltage);
  }
  return done;
}

bool DriveUnit::goes_step_by_step() const noexcept {
  return std::ranges::any_of(running_.all(), &Axis::goes_step_by_step);
}

void DriveUnit::run_steps(long steps) noexcept {
  const long at_once = interlude_ == nullptr ? static_cast<long>(kMostPlannedSteps) : kStepsInASlice;
  const long most = goes_step_by_step() ? 1 : at_once;
  DriveUnit* const self = this;
  for (long done = 0; done < steps;) {
    done += run_steps({&self, 1}, std::min(steps - done, most));
    if (interlude_ != nullptr) interlude_->between_steps();
  }
  lowest_dc_voltage_ = std::min(lowest_dc_voltage_, dc_link_.voltage());
}

/// Whether an axis has position control, or switches are beside its way.
bool DriveUnit::is_sliced() const noexcept {
  return !switches_.empty() || std::ranges::any_of(running_.all(), &Axis::positions);
}

/// Slices of 1 ms begin among the steps where there are some.
void DriveUnit::make_steps() noexcept {
  lowest_dc_voltage_ = dc_link_.voltage();
  const bool sliced = is_sliced();
  if (observer_ == nullptr && !sliced) [[likely]]
    return run_steps(running_.steps);
  for (long step = 0; step < running_.steps;) {
    if (sliced && steps_in_slice_ == 0) run_slice();
    const long until_slice =
        sliced ? std::min(running_.steps - step, kStepsInASlice - steps_in_slice_) : running_.steps;
    const long count = observer_ != nullptr ? 1 : until_slice;
    run_steps(count);
    step += count;
    if (sliced) steps_in_slice_ = (steps_in_slice_ + count) % kStepsInASlice;
    if (observer_ != nullptr && step < running_.steps) observer_->on_step(step);
  }
}

bool DriveUnit::shares_steps() const noexcept {
  return running_.count > 0 && observer_ == nullptr && interlude_ == nullptr && !is_sliced() &&
         !goes_step_by_step();
}

/// Once one of them has tripped each goes on by itself: it may trip in every step.
void DriveUnit::make_steps(std::span<DriveUnit* const> units) noexcept {
  for (DriveUnit* const unit : units) unit->lowest_dc_voltage_ = unit->dc_link_.voltage();
  long left = units.front()->running_.steps;
  for (bool sound = true; sound && left > 0;) {
    const long planned = std::min(left, static_cast<long>(kMostPlannedSteps));
    const long made = run_steps(units, planned);
    sound = made == planned;
    left -= made;
  }
  for (DriveUnit* const unit : units) unit->run_steps(left);
}

}  // namespace drive
