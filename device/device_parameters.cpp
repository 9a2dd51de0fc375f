// Whence the parameters of the unit come: presets of the configuration over saved values over those of a new unit.
#include <array>

#include "device/abort_codes.hpp"
#include "device/device.hpp"

namespace device {
namespace {

/// Objects with indices `first` to `last`.
struct ObjectRange {
  std::uint16_t first;
  std::uint16_t last;
};
/// The objects that show parameters of @p group, and what belongs to them.
constexpr ObjectRange objects_of(ParameterGroup group) noexcept {
  constexpr std::array kRanges{ObjectRange{0x1000, 0x9FFF}, ObjectRange{0x1000, 0x1FFF},
                               ObjectRange{0x6000, 0x9FFF}};
  return kRanges[static_cast<std::size_t>(group) - 1];
}

}  // namespace

/// The configuration lies over the parameters of @p group, whatever they were before; then objects show them.
void Device::bring_out(ParameterGroup group) noexcept {
  presets_.apply(group);
  if (group == ParameterGroup::All) unit_.follow_function_modules();
  const ObjectRange objects = objects_of(group);
  mirrored_parameters_.bring_out(objects.first, objects.last);
}

tl::expected<void, drive::image_format::Error> Device::load_parameters(std::span<const std::byte> image) noexcept {
  auto loaded = storage_.adopt(image);
  if (loaded) bring_out(ParameterGroup::All);
  return loaded;
}

tl::expected<void, drive::image_format::Error> Device::load_retained(std::span<const std::byte> image) noexcept {
  return drive::retained_image::load(unit_, image);
}

canopen::Result<void> Device::on_store(std::uint8_t sub_index) noexcept {
  const auto refused = storage_.store(sub_index);
  if (storage_.is_saving()) node_.defer_answer();
  return result(refused);
}

canopen::Result<void> Device::on_restore(std::uint8_t sub_index) noexcept {
  return result(storage_.restore(sub_index));
}

void Device::on_stored(bool kept, canopen::TimePoint now) noexcept {
  now_ = now;
  storage_.end_save(kept);
  node_.send_to(sink_);  // SDO requests are answered off the bus too
  node_.answer_deferred(kept ? canopen::Result<void>{} : canopen::refuse(canopen::AbortCode::HardwareError), now);
  if (communication_.is_bus_off()) node_.send_to(nowhere_);
}

std::span<const std::byte> Device::retained(canopen::TimePoint now) noexcept {
  tell_time(now);
  return drive::retained_image::save(unit_, retained_).value_or(std::span<const std::byte>{});
}

void Device::on_reset(canopen::NmtCommand command) noexcept {
  const bool all = command == canopen::NmtCommand::ResetNode;
  const ParameterGroup group = all ? ParameterGroup::All : ParameterGroup::Communication;
  if (all) {
    switch_off();
  } else {
    lose_connection();
  }
  show_messages();
  storage_.reload(group);
  take_over(group, all ? wired_at_start() : UnitProcessData::WiredBy::Before);
}

UnitProcessData::WiredBy Device::wired_at_start() const noexcept {
  return storage_.has_saved() ? UnitProcessData::WiredBy::Saved : UnitProcessData::WiredBy::Factory;
}

/// The parameters of @p group have become others: all that works with them.
void Device::take_over(ParameterGroup group, UnitProcessData::WiredBy wired) noexcept {
  bring_out(group);
  take_over_parameters();
  process_data_.take_over(wired);
  unit_.send_process_data();
  show_values();
}

/// What parameters of the unit say of its communication, whichever way they came.
void Device::take_over_parameters() noexcept {
  communication_.set_start_state();
  take_over_cycle();
  rpdo_monitor_.set_time(unit_.object(drive::kControlUnitNumber)->read(RpdoMonitor::kParameter).value_or(0.0));
}

/// The state of a new unit, at once: the vendor's departure from CiA 301, which waits for the next reset.
void Device::restore(std::uint8_t which) noexcept {
  const ParameterGroup group{which};
  tell_time(now_);
  storage_.reset(group);
  if (group == ParameterGroup::All) listener_.on_restore();
  const ObjectRange objects = objects_of(group);
  dictionary_.restore(objects.first, objects.last);
  for (AxisObjects& axis : axes_) axis.forget_written();
  take_over(group, group == ParameterGroup::Communication ? UnitProcessData::WiredBy::Before
                                                          : UnitProcessData::WiredBy::Factory);
  error_objects_.show_again();
  if (group != ParameterGroup::Application) node_.reload(now_);
  show_messages();
}

}  // namespace device
