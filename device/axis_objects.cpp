#include "device/axis_objects.hpp"

#include <array>

#include "device/object_index.hpp"

namespace device {
namespace {

/// Objects whose writing over SDO is an input of the axis, as an RPDO is.
constexpr std::array kInputs{object::kControlword, object::kTargetVelocity, object::kTargetTorque,
                             object::kModesOfOperation};

}  // namespace

AxisObjects::AxisObjects(canopen::Dictionary& dictionary, drive::Axis& axis, AxisListener& listener)
    : axis_{axis},
      listener_{listener},
      process_data_{dictionary, axis.axis_number(), drive::BusScaling{axis.parameters()}},
      parameter_objects_{dictionary, axis, drive::BusScaling{axis.parameters()}, *this} {
  for (const std::uint16_t index : kInputs)
    dictionary.own_write(object::on_axis(index, axis.axis_number()), 0, *this);
}

std::optional<drive::Setpoints> AxisObjects::take_setpoints() noexcept {
  if (idle_) return std::nullopt;
  drive::Setpoints wanted = setpoints();
  wanted.controlword = written_controlwords_.take().value_or(wanted.controlword);
  return wanted;
}

void AxisObjects::end_cycles() noexcept {
  idle_ = axis_.is_quiescent() && written_controlwords_.is_empty();
}

void AxisObjects::wake() noexcept {
  if (!idle_) return;
  idle_ = false;
  listener_.on_awake();
}

void AxisObjects::on_rpdo() noexcept {
  // A controlword in process data is the newer one; an RPDO without any leaves the written ones in force.
  const bool overwritten = process_data_.controlword() != written_controlwords_.newest();
  if (overwritten && !written_controlwords_.is_empty()) written_controlwords_.clear();
  wake();
}

canopen::Result<void> AxisObjects::write(const canopen::Entry& entry, std::int64_t value) {
  if (object::on_first_axis(entry.index) == object::kControlword)
    written_controlwords_.put(static_cast<std::uint16_t>(value));
  wake();
  return {};
}

}  // namespace device
