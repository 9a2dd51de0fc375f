// What comes into the blocks of an axis and goes through no parameter.
#include <array>
#include <utility>

#include "drive/axis/axis.hpp"

namespace drive {
namespace {

/// A bit of the controlword that an input of a block is connected to for good.
struct FixedInterconnection {
  ControlwordBit bit;
  BitInput input;
};
constexpr std::array kFixedInterconnections{
    FixedInterconnection{ControlwordBit::EnableRamp, bit_input<&SetpointChannel::Inputs::vl_enable_ramp>},
    FixedInterconnection{ControlwordBit::UnlockRamp, bit_input<&SetpointChannel::Inputs::vl_unlock_ramp>},
    FixedInterconnection{ControlwordBit::ReferenceRamp, bit_input<&SetpointChannel::Inputs::vl_reference_ramp>},
    FixedInterconnection{ControlwordBit::Halt, bit_input<&SequenceControl::Inputs::halt>},
};

/// 6060h as process data, which changes nothing where the axis positions.
std::optional<std::int8_t> requested_mode(const Axis& axis) noexcept {
  return axis.positions() ? std::nullopt : axis.process_data().requested_mode;
}

}  // namespace

void Axis::take_image() noexcept {
  const ProcessDataImage& image = process_data();
  block<SpeedControl>().inputs.requested_mode = drive::requested_mode(*this);
  if (controlword_ == image.controlword) return;
  controlword_ = image.controlword;
  for (const FixedInterconnection& row : kFixedInterconnections)
    row.input.member(block(row.input.block), 0) = image.bit(row.bit);
}

bool Axis::has_new_image() const noexcept {
  return controlword_ != process_data().controlword ||
         block<SpeedControl>().inputs.requested_mode != drive::requested_mode(*this);
}

void Axis::command(const Setpoints& setpoints) noexcept {
  const auto bit = [&](unsigned number) { return (setpoints.controlword >> number & 1U) != 0; };
  const auto named = [&](ControlwordBit name) { return bit(static_cast<unsigned>(name)); };
  controlword_ = setpoints.controlword;
  block<SequenceControl>().inputs = {.on = bit(0),
                                     .no_off2 = bit(1),
                                     .no_off3 = bit(2),
                                     .enable_operation = bit(3),
                                     .halt = named(ControlwordBit::Halt)};
  block<ExternalMessages>().inputs = {.acknowledge_1 = bit(7)};
  block<OperatorPanel>().inputs = {};
  block<SpeedControl>().inputs = {};
  block<Jog>().inputs = {};
  block<SetpointChannel>().inputs = {.vl_enable_ramp = named(ControlwordBit::EnableRamp),
                                     .vl_unlock_ramp = named(ControlwordBit::UnlockRamp),
                                     .vl_reference_ramp = named(ControlwordBit::ReferenceRamp),
                                     .main_setpoint = setpoints.speed};
  block<TorqueSetpoint>().inputs = {.setpoint = setpoints.torque};
}

}  // namespace drive
