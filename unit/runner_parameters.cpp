// Whence the parameters of the unit come: presets of the configuration over saved values over those of a new unit;
// and what follows from a write beyond the drive object that it is about.
#include <array>

#include "unit/runner.hpp"

namespace unit {
namespace {

// p0970 resets a drive object from p0010 = 30, which it ends.
constexpr std::uint16_t kResetObject = 970;
constexpr std::uint16_t kFilter = 10;

// p8848 comes into force when p0009 is left.
constexpr std::uint16_t kCyclePeriod = 8848;
constexpr std::uint16_t kDeviceFilter = 9;

double control_unit_value(const drive::DriveUnit& unit, std::uint16_t number) noexcept {
  return unit.object(drive::kControlUnitNumber)->read(number).value_or(0.0);
}

}  // namespace

/// The configuration lies over the parameters of @p group, whatever they were before.
void Runner::lay_presets(ParameterGroup group) noexcept {
  presets_.apply(group);
  if (group == ParameterGroup::All) unit_.follow_function_modules();
}

tl::expected<void, Runner::ImageError> Runner::load_parameters(std::span<const std::byte> image) noexcept {
  auto loaded = storage_.adopt(image);
  if (!loaded) return loaded;
  lay_presets(ParameterGroup::All);
  adopt({.cause = Replacement::Cause::Loaded});
  return loaded;
}

tl::expected<void, Runner::ImageError> Runner::load_retained(std::span<const std::byte> image) noexcept {
  return drive::retained_image::load(unit_, image);
}

std::span<const std::byte> Runner::retained(TimePoint now) noexcept {
  tell_time(now);
  return drive::retained_image::save(unit_, retained_).value_or(std::span<const std::byte>{});
}

void Runner::on_stored(bool kept, TimePoint now) noexcept {
  set_now(now);
  storage_.end_save(kept);
  for (Face* const face : faces_) face->on_stored(kept);
}

void Runner::adopt(const Replacement& replacement) noexcept {
  for (Face* const face : faces_) face->adopt(replacement);
}

void Runner::resume(const Replacement& replacement) noexcept {
  for (Face* const face : faces_) face->resume(replacement);
}

void Runner::take_over_period() noexcept {
  clock_.set_period(CycleClock::period_of(control_unit_value(unit_, kCyclePeriod)));
}

/// The parameters of a group have become others: all that works with them.
void Runner::take_over(const Replacement& replacement) noexcept {
  lay_presets(replacement.group);
  take_over_period();
  adopt(replacement);
  unit_.send_process_data();
  for (Face* const face : faces_) face->show();
  resume(replacement);
}

void Runner::reload(ParameterGroup group) noexcept {
  storage_.reload(group);
  take_over({.cause = Replacement::Cause::Reset, .group = group});
}

tl::expected<void, drive::ParameterError> Runner::write_parameter(std::uint8_t object, std::uint16_t number,
                                                                  std::size_t index, double value,
                                                                  TimePoint now) noexcept {
  set_now(now);
  auto written = access_.find({object, number, index}).and_then([&](const drive::FoundParameter& parameter) {
    return access_.write(parameter, value);
  });
  if (written) follow_up();
  return written;
}

void Runner::on_parameter_written(std::uint8_t object, std::uint16_t number) noexcept {
  const bool left_reset = number == kResetObject && unit_.object(object)->read(kFilter) == 0.0;
  if (left_reset) follow_ups_.add(FollowUp::RestoreObject, object);
  if (number == kDeviceFilter) follow_ups_.add(FollowUp::RestartUnit);
  show_messages_later();
  if (object < unit_.first_axis()) return wake();
  wake(mask_of(object - unit_.first_axis() + std::size_t{1}));
}

void Runner::follow_up() noexcept {
  using Work = void (Runner::*)(std::uint8_t) noexcept;
  static constexpr std::array<Work, static_cast<std::size_t>(FollowUp::Count)> kWork{
      &Runner::restore_object, &Runner::show_messages, &Runner::restart_if_due,
      &Runner::restore_group,  &Runner::reset,
  };
  for (bool more = true; more;) {
    while (!follow_ups_.is_empty()) {
      const auto item = follow_ups_.take();
      (this->*kWork[static_cast<std::size_t>(item.what)])(item.argument);
    }
    more = false;
    for (Face* const face : faces_) more = face->follow_up() || more;
  }
}

/// The faces follow the parameters of drive object @p object, which are those of a new one.
void Runner::restore_object(std::uint8_t object) noexcept {
  const Replacement replacement{.cause = Replacement::Cause::Restored, .object = object};
  adopt(replacement);
  resume(replacement);
}

/// The unit starts again with the parameters as they are if p0009 has been left with another p8848 than is in
/// force.
void Runner::restart_if_due(std::uint8_t) noexcept {
  const bool is_left = control_unit_value(unit_, kDeviceFilter) == 0.0;
  if (!is_left || CycleClock::period_of(control_unit_value(unit_, kCyclePeriod)) == clock_.period()) return;
  tell_time(now_);
  restart_unit();
  take_over_period();
  const Replacement replacement{.cause = Replacement::Cause::Restart};
  adopt(replacement);
  resume(replacement);
  show_messages();
}

/// The state of a new unit, at once: the vendor's departure from CiA 301, which waits for the next reset.
void Runner::restore_group(std::uint8_t which) noexcept {
  const ParameterGroup group{which};
  tell_time(now_);
  storage_.reset(group);
  if (group == ParameterGroup::All) keeper_.on_restore();
  take_over({.cause = Replacement::Cause::Restored, .group = group});
  show_messages();
}

void Runner::power_cycle() noexcept {
  for (Face* const face : faces_)
    if (face->restart_unit()) return;
  tell_time(now_);
  restart_unit();
  show_messages();
  reload(ParameterGroup::All);
}

}  // namespace unit
