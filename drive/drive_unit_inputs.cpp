// What the inputs of the control unit and of the infeed make of them in a cycle.
#include <array>
#include <utility>

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
  const bool all = wiring_->acknowledge_all();
  if (all && !acknowledge_all_) acknowledge();
  acknowledge_all_ = all;
  const AxisInputs before = std::exchange(control_unit_inputs_, wiring_->inputs(0));
  follow_messages(control_unit_, before, control_unit_inputs_);
  if (has_acknowledgement(before, control_unit_inputs_)) control_unit_.acknowledge();
}

void DriveUnit::run_infeed(double duration) noexcept {
  if (!infeed_) return;
  const AxisInputs inputs = wiring_->infeed_inputs();
  follow_messages(*infeed_, infeed_->inputs(), inputs);
  infeed_->cycle(inputs, duration, {.voltage = dc_link_.voltage(), .lowest = lowest_dc_voltage_});
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
