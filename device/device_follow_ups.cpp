// What written parameters and other requests lead to when the answer is out.
#include <array>

#include "device/device.hpp"

namespace device {
namespace {

// p0970 resets a drive object from p0010 = 30, which it ends.
constexpr std::uint16_t kResetObject = 970;
constexpr std::uint16_t kFilter = 10;

// p8848 comes into force when p0009 is left.
constexpr std::uint16_t kCyclePeriod = 8848;
constexpr std::uint16_t kDeviceFilter = 9;

}  // namespace

void Device::on_parameter_written(std::uint8_t object, std::uint16_t number) noexcept {
  const bool left_reset = number == kResetObject && unit_.object(object)->read(kFilter) == 0.0;
  if (left_reset) follow_ups_.add(FollowUp::RestoreObject, object);
  if (number == kDeviceFilter) follow_ups_.add(FollowUp::RestartUnit);
  follow_ups_.add(FollowUp::ShowMessages);
  if (storage_.is_saving()) node_.defer_answer();
  if (object < unit_.first_axis()) return wake();
  axes_[object - unit_.first_axis()].wake();
}

/// What requests have led to, now that the answer is out.
void Device::follow_up() noexcept {
  using Work = void (Device::*)(std::uint8_t) noexcept;
  static constexpr std::array<Work, static_cast<std::size_t>(FollowUp::Count)> kWork{
      &Device::wire_mappings, &Device::restore_object, &Device::show_messages, &Device::plan_bus_restart,
      &Device::restart_unit,  &Device::command_node,   &Device::restore,       &Device::reset_node,
  };
  while (!follow_ups_.is_empty()) {
    const FollowUps::Item item = follow_ups_.take();
    (this->*kWork[static_cast<std::size_t>(item.what)])(item.argument);
  }
}

void Device::wire_mappings(std::uint8_t) noexcept {
  if (process_data_.follow_changed_mappings()) wake();
}

void Device::restart_unit(std::uint8_t) noexcept {
  if (restart_is_due()) restart();
}

void Device::command_node(std::uint8_t command) noexcept {
  node_.command(static_cast<canopen::NmtCommand>(command), now_);
}

void Device::reset_node(std::uint8_t) noexcept {
  node_.command(canopen::NmtCommand::ResetNode, now_);
}

/// The objects of drive object @p object follow its parameters, which are those of a new one.
void Device::restore_object(std::uint8_t object) noexcept {
  mirrored_parameters_.bring_out(object);
  process_data_.take_over(UnitProcessData::WiredBy::Factory);
  node_.reload(now_);
}

/// Whether p0009 has been left with another p8848 than is in force.
bool Device::restart_is_due() const noexcept {
  const drive::DriveObject& control_unit = *unit_.object(drive::kControlUnitNumber);
  return control_unit.read(kDeviceFilter) == 0.0 &&
         CycleClock::period_of(control_unit.read(kCyclePeriod).value_or(0.0)) != clock_.period();
}

/// The unit starts again with the parameters as they are.
void Device::restart() noexcept {
  tell_time(now_);
  restarting_ = true;
  switch_off();
  rpdo_monitor_.stop();
  take_over_parameters();
  process_data_.take_over(UnitProcessData::WiredBy::Before);
  node_.start(now_);
  restarting_ = false;
  show_messages();
}

/// p8848 comes into force.
void Device::take_over_cycle() noexcept {
  const double period = unit_.object(drive::kControlUnitNumber)->read(kCyclePeriod).value_or(0.0);
  clock_.set_period(CycleClock::period_of(period));
  node_.set_pdo_cycle(clock_.grid());
  rpdo_monitor_.set_cycle(clock_.grid());
}

}  // namespace device
