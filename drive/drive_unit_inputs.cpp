// What the inputs of the control unit and of the infeed make of them in a cycle.
#include <array>

#include "drive/drive_unit.hpp"
#include "drive/wiring.hpp"

namespace drive {
namespace {

/// A message that lasts as long as an input of the control unit or the infeed is 0.
struct InputMessage {
  std::uint16_t number;
  bool AxisInputs::*signal;
};
constexpr std::array kUnitMessages{
    InputMessage{7850, &AxisInputs::no_external_alarm_1},
    InputMessage{7860, &AxisInputs::no_external_fault_1},
    InputMessage{7861, &AxisInputs::no_external_fault_2},
    InputMessage{7862, &AxisInputs::no_external_fault_3},
};

/// The messages of @p object by its inputs, which were @p before.
void follow_messages(DriveObject& object, const AxisInputs& before, const AxisInputs& now) noexcept {
  for (const InputMessage& message : kUnitMessages) {
    const bool signal = now.*message.signal;
    if (signal == before.*message.signal) continue;
    if (signal)
      object.withdraw(message.number);
    else
      static_cast<void>(object.raise(message.number, 0, Cause::Present));
  }
}

}  // namespace

/// Of the control unit: p2102 acknowledges the faults of all drive objects, p2103 to p2105 its own, p2106 to p2108
/// and p2112 bring messages.
void DriveUnit::follow_unit_inputs() noexcept {
  const bool acknowledged_all = control_unit_.unit_inputs().acknowledge_all;
  wiring_->take(control_unit_, kBlock<UnitInputs>);
  if (control_unit_.unit_inputs().acknowledge_all && !acknowledged_all) acknowledge();
  const AxisInputs before = control_unit_.inputs();
  wiring_->take(control_unit_, kBlock<AxisInputs>);
  follow_messages(control_unit_, before, control_unit_.inputs());
  if (has_acknowledgement(before, control_unit_.inputs())) control_unit_.acknowledge();
}

void DriveUnit::run_infeed(double duration) noexcept {
  if (!infeed_) return;
  wiring_->take(*infeed_, kBlock<AxisInputs>);
  follow_messages(*infeed_, infeed_->inputs_before(), infeed_->inputs());
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
