#include "unit/parameter_storage.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "drive/images/module_connections.hpp"

namespace unit {
namespace {

using drive::Refusal;
using drive::storage_image::Selection;

constexpr std::uint16_t kRestart = 972;
constexpr std::uint16_t kAdjustmentOffset = 2525;

// Values of p0972 and p0976.
constexpr int kRestartNow = 1;
constexpr int kRestartAfterOperational = 3;
constexpr int kFactoryValues = 1;
constexpr int kSavedValues = 2;

}  // namespace

constinit const std::array<ParameterStorage::Command, 4> ParameterStorage::kCommands{
    Command{971, &ParameterStorage::save_object},
    Command{kRestart, &ParameterStorage::restart},
    Command{976, &ParameterStorage::load_all},
    Command{977, &ParameterStorage::save_all},
};

ParameterStorage::ParameterStorage(drive::DriveUnit& unit, UnitParameters& parameters, ParameterKeeper& keeper,
                                   FollowUps<FollowUp>& follow_ups)
    : unit_{unit}, keeper_{keeper}, follow_ups_{follow_ups} {
  const std::size_t size = drive::storage_image::size(unit);
  for (std::vector<std::byte>* const room : {&image_, &spare_}) room->reserve(size);
  for (const Command& command : kCommands) parameters.answer(command.number, *this);
}

/// Of its whole length, and in memory that is taken with the first use.
std::span<std::byte> ParameterStorage::spare() noexcept {
  spare_.resize(spare_.capacity());
  return spare_;
}

tl::expected<void, ParameterStorage::Error> ParameterStorage::adopt(std::span<const std::byte> image) noexcept {
  if (const auto loaded = drive::storage_image::load(unit_, image); !loaded) return loaded;
  drive::connect_new_modules(unit_, drive::SavedValues{image});
  unit_.follow_function_modules();
  // Parameters that the image does not have are as in a new unit, and part of it from now on.
  std::size_t length = 0;
  for (std::uint8_t number = drive::kControlUnitNumber; unit_.object(number) != nullptr; ++number) {
    if (!drive::storage_image::has(unit_, image, number)) continue;
    const auto written = drive::storage_image::update(unit_, std::span{image_}.first(length), spare(),
                                                      {.object = number, .kept = true});
    if (!written) return tl::unexpected{written.error()};
    length = written->size();
    std::swap(image_, spare_);
  }
  length_ = length;
  return {};
}

std::optional<Refusal> ParameterStorage::save(const Selection& selection) noexcept {
  if (is_saving()) return Refusal::NotNow;
  const auto written = drive::storage_image::update(unit_, image(), spare(), selection);
  assert(written);
  if (!written) return Refusal::Failed;
  saving_ = written->size();
  const Keeping keeping = keeper_.on_store(*written);
  if (keeping != Keeping::Begun) end_save(keeping == Keeping::Kept);
  if (keeping == Keeping::Refused) return Refusal::NotNow;
  return keeping == Keeping::Failed ? std::optional<Refusal>{Refusal::Failed} : std::nullopt;
}

void ParameterStorage::end_save(bool kept) noexcept {
  const std::size_t length = std::exchange(saving_, 0U);
  if (!kept) return;
  length_ = length;
  std::swap(image_, spare_);
  tell_axes();
}

/// An adjustment of an absolute encoder is no longer unsaved once its offset is in the image.
void ParameterStorage::tell_axes() noexcept {
  for (drive::Axis& axis : unit_.axes()) {
    auto& position = axis.block<drive::ActualPosition>();
    const auto offset = saved().find(axis.number(), kAdjustmentOffset, 0);
    if (offset && decode(*offset) == position.settings.adjustment_offset) position.on_saved();
  }
}

std::optional<Refusal> ParameterStorage::store(ParameterGroup group) noexcept {
  const bool partial = group != ParameterGroup::All;
  if (partial && !drive::storage_image::is_complete(unit_, image())) return Refusal::NotNow;
  return save({.rows = groups_.saved(group)});
}

std::optional<Refusal> ParameterStorage::restore(ParameterGroup group) noexcept {
  return ask_for(FollowUp::Restore, static_cast<std::uint8_t>(group));
}

std::optional<Refusal> ParameterStorage::ask_for(FollowUp what, std::uint8_t argument) noexcept {
  if (pulses_enabled() || is_saving()) return Refusal::NotNow;
  follow_ups_.add(what, argument);
  return std::nullopt;
}

bool ParameterStorage::pulses_enabled() const noexcept {
  return std::ranges::any_of(unit_.axes(), [](const drive::Axis& axis) { return axis.actual().pulses_enabled; });
}

std::optional<double> ParameterStorage::value_of(const ParameterPlace& place) const noexcept {
  return place.row.number == kRestart ? restart_ : 0;
}

std::optional<Refusal> ParameterStorage::take(const ParameterPlace& place, double value) noexcept {
  const auto* const command = std::ranges::find(kCommands, place.row.number, &Command::number);
  return (this->*command->carry_out)(place.object, static_cast<int>(value));
}

std::optional<Refusal> ParameterStorage::save_object(const drive::DriveObject& object, int value) noexcept {
  return value == 0 ? std::nullopt : save({.object = object.number()});
}

std::optional<Refusal> ParameterStorage::save_all(const drive::DriveObject&, int value) noexcept {
  if (value > 1) return Refusal::IllegalValue;
  return value == 0 ? std::nullopt : save({});
}

std::optional<Refusal> ParameterStorage::load_all(const drive::DriveObject&, int value) noexcept {
  if (value > kSavedValues) return Refusal::IllegalValue;
  if (value == 0) return std::nullopt;
  if (value != kFactoryValues) return ask_for(FollowUp::Reset);
  return restore(ParameterGroup::All);
}

std::optional<Refusal> ParameterStorage::restart(const drive::DriveObject&, int value) noexcept {
  if (value == kRestartNow) follow_ups_.add(FollowUp::Reset);
  restart_ = value == kRestartNow ? 0 : value;
  return std::nullopt;
}

void ParameterStorage::on_operational_left() noexcept {
  if (restart_ == kRestartAfterOperational) follow_ups_.add(FollowUp::Reset);
}

void ParameterStorage::reset(ParameterGroup group) noexcept {
  unit_.restore_parameters(groups_.reset(group));
  if (group == ParameterGroup::All) unit_.leave_commissioning();
}

void ParameterStorage::reload(ParameterGroup group) noexcept {
  unit_.restore_parameters(groups_.saved(group));
  if (group == ParameterGroup::All) {
    unit_.leave_commissioning();
    restart_ = 0;
  }
  if (length_ == 0) return;
  [[maybe_unused]] const auto loaded = drive::storage_image::load(unit_, image(), {.rows = groups_.saved(group)});
  assert(loaded);
}

}  // namespace unit
