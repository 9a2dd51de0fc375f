// What the inputs of the drive objects make of them in a cycle.
#include <algorithm>

#include "drive/drive_unit.hpp"
#include "drive/wiring.hpp"

namespace drive {
namespace {

/// Messages of @p object by what its inputs have brought to @p external.
void follow_messages(DriveObject& object, ExternalMessages& external) noexcept {
  external.follow([&](std::uint16_t number, bool present, bool before) {
    if (present == before) return;
    if (present)
      static_cast<void>(object.raise(number, 0, Cause::Present));
    else
      object.withdraw(number);
  });
}

}  // namespace

/// A phase is the group of inputs with its number.
void DriveUnit::group_inputs() {
  for (const Axis& axis : axes_)
    for (std::size_t phase = 0; phase < kPhases; ++phase)
      wiring_->add_group(axis, Axis::inputs_of(static_cast<Phase>(phase)));
}

void DriveUnit::take_inputs(const Axis& axis, Phase phase) noexcept {
  wiring_->take_group(axis, static_cast<std::size_t>(phase));
}

bool DriveUnit::has_new_inputs(const Axis& axis, Phase phase) const noexcept {
  return wiring_->changed(axis, static_cast<std::size_t>(phase));
}

/// Whether @p axis is quiescent and nothing new acts on it as a cycle begins.
bool DriveUnit::has_nothing_to_do(const Axis& axis) const noexcept {
  if (!axis.is_quiescent() || axis.has_new_image() || has_new_inputs(axis, Phase::Sequence)) return false;
  return !axis.positions() ||
         std::ranges::none_of(kInTheSlices, [&](Phase phase) { return has_new_inputs(axis, phase); });
}

/// Of the control unit: p2102 acknowledges the faults of all drive objects, p2103 to p2105 its own, p2106 to p2108
/// and p2112 bring messages; p3104 is the ping of the clock.
void DriveUnit::follow_unit_inputs() noexcept {
  const UnitInputs before = control_unit_.unit_inputs();
  wiring_->take(control_unit_, kBlock<UnitInputs>);
  if (const UnitInputs& inputs = control_unit_.unit_inputs(); inputs != before) {
    if (inputs.acknowledge_all && !before.acknowledge_all) acknowledge();
    if (inputs.utc_ping && !before.utc_ping) control_unit_.clock().ping();
  }
  ExternalMessages& external = control_unit_.external_messages();
  wiring_->take(control_unit_, kBlock<ExternalMessages>);
  follow_messages(control_unit_, external);
  if (external.acknowledges()) control_unit_.acknowledge();
}

std::optional<PanelRefusal> DriveUnit::panel_refusal(std::size_t axis) noexcept {
  // p0806 may have been written since the last cycle.
  wiring_->connect();
  wiring_->take(axes_[axis], kBlock<OperatorPanel>);
  return axes_[axis].block<OperatorPanel>().refusal(axes_[axis].actual().pulses_enabled);
}

std::optional<PanelRefusal> DriveUnit::take_control(std::size_t axis, double timeout) noexcept {
  const std::optional<PanelRefusal> refusal = panel_refusal(axis);
  if (!refusal) axes_[axis].block<OperatorPanel>().take(timeout);
  return refusal;
}

void DriveUnit::run_infeed(double duration) noexcept {
  if (!infeed_) return;
  wiring_->take(*infeed_, kBlock<InfeedInputs>);
  wiring_->take(*infeed_, kBlock<ExternalMessages>);
  follow_messages(*infeed_, infeed_->external_messages());
  infeed_->cycle(duration, {.voltage = dc_link_.voltage(), .lowest = lowest_dc_voltage_});
  connect_line();
}

/// The line contactor of the infeed, where there is one.
void DriveUnit::connect_line() noexcept {
  dc_link_.set_line_voltage(!infeed_ || infeed_->is_connected() ? line_voltage_ : 0.0);
}

void DriveUnit::set_line_voltage(double voltage) noexcept {
  line_voltage_ = voltage;
  connect_line();
}

}  // namespace drive
