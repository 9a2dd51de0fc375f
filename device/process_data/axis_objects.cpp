#include "device/process_data/axis_objects.hpp"

#include <array>

#include "device/objects/object_index.hpp"

namespace device {
namespace {

/// Objects whose writing over SDO is an input of the axis, as an RPDO is; the free ones too.
constexpr std::array kInputs{object::kControlword, object::kTargetVelocity, object::kTargetTorque,
                             object::kVlTargetVelocity, object::kModesOfOperation};

}  // namespace

AxisObjects::AxisObjects(canopen::Dictionary& dictionary, drive::Axis& axis, const ProcessDataBuffers& places,
                         unit::Runner& runner)
    : axis_{axis},
      places_{places},
      runner_{runner},
      mask_{unit::mask_of(axis.axis_number())},
      process_data_{dictionary, axis, places},
      parameter_objects_{dictionary, axis, *this} {
  for (const std::uint16_t index : kInputs)
    dictionary.own_write(object::on_axis(index, axis.axis_number()), 0, *this);
  for (const std::uint16_t index : {object::kModesOfOperation, object::kSupportedModes})
    dictionary.own_read(object::on_axis(index, axis.axis_number()), 0, *this);
  const auto own_free = [&](std::uint16_t first, std::uint16_t count) {
    for (std::uint16_t i = 0; i < count; ++i) {
      const auto index = static_cast<std::uint16_t>(object::free_on_axis(first, axis.axis_number()) + i);
      dictionary.own_write(index, 0, *this);
    }
  };
  own_free(object::kReceiveWords, object::kFreeWords);
  own_free(object::kReceiveDoubleWords, object::kFreeDoubleWords);
}

void AxisObjects::receive() noexcept {
  process_data_.receive(written_controlwords_.take().value_or(process_data_.controlword()));
}

void AxisObjects::on_rpdo() noexcept {
  // A controlword in process data is the newer one; an RPDO without any leaves the written ones in force.
  const bool overwritten = process_data_.controlword() != written_controlwords_.newest();
  if (overwritten && !written_controlwords_.is_empty()) written_controlwords_.clear();
  wake();
}

bool AxisObjects::is_placed(const canopen::Entry& entry) const noexcept {
  return places_.received().find(entry.index) != nullptr;
}

/// The mode as a parameter is p1300; as process data it is for the cycle.
canopen::Result<void> AxisObjects::write(const canopen::Entry& entry, std::int64_t value) {
  const bool is_free = entry.index < object::kFirstProfileObject;
  const std::uint16_t object = is_free ? entry.index : object::on_first_axis(entry.index);
  if (object == object::kControlword) written_controlwords_.put(static_cast<std::uint16_t>(value));
  const bool is_mode = object == object::kModesOfOperation;
  if (is_mode && !is_placed(entry)) axis_.request_mode(static_cast<std::int8_t>(value));
  wake();
  return {};
}

canopen::Result<std::int64_t> AxisObjects::read(const canopen::Entry& entry, std::int64_t stored) {
  if (object::on_first_axis(entry.index) == object::kSupportedModes)
    return drive::supported_modes(axis_.has_encoder());
  return is_placed(entry) ? stored : axis_.requested_mode();
}

}  // namespace device
