// Parameters of the unit as they are transferred.
#include <array>

#include "drive/drive_unit.hpp"
#include "drive/parameter/transfer.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kAlarmCounter = 2111;  // p2111

ParameterError no_object(std::uint16_t number) noexcept {
  return {Refusal::NoDriveObject, number, nullptr};
}

}  // namespace

tl::expected<ParameterValue, ParameterError> DriveUnit::read(std::uint8_t object, std::uint16_t number,
                                                             std::size_t index) const noexcept {
  const DriveObject* const owner = this->object(object);
  if (owner == nullptr) return tl::unexpected{no_object(number)};
  return owner->parameter(number, index).map([&](const PlacedRow* placed) {
    return read(*owner, *placed, index);
  });
}

ParameterValue DriveUnit::read(const DriveObject& object, const PlacedRow& placed, std::size_t index) noexcept {
  return transferred(placed.row->type, object.value(placed, index));
}

tl::expected<void, ParameterError> DriveUnit::write(std::uint8_t object, std::uint16_t number, std::size_t index,
                                                    const ParameterValue& value) noexcept {
  DriveObject* const owner = this->object(object);
  if (owner == nullptr) return tl::unexpected{no_object(number)};
  const auto found = owner->parameter(number, index);
  const auto wrong_type = [&](const ParameterRow& row) {
    return tl::unexpected{ParameterError{Refusal::WrongType, number, &row}};
  };
  if (!found) {
    const ParameterRow* const row = found.error().row;
    if (row != nullptr && row->type != value.type) return wrong_type(*row);
    return tl::unexpected{found.error()};
  }
  if ((*found)->row->type != value.type) return wrong_type(*(*found)->row);
  return write(*owner, **found, index, decode(value));
}

tl::expected<void, ParameterError> DriveUnit::write(DriveObject& object, const PlacedRow& placed,
                                                    std::size_t index, double value) noexcept {
  return placed.row->number == kAlarmCounter ? clear_alarms(object, placed, value)
                                             : object.write(placed, index, value);
}

/// p2111 = 0 ends latched alarms where they came from and where they spread to.
tl::expected<void, ParameterError> DriveUnit::clear_alarms(DriveObject& object, const PlacedRow& counter,
                                                           double count) noexcept {
  std::array<std::uint16_t, FaultMemory::kCapacity> latched{};
  std::size_t number = 0;
  for (const FaultEntry& alarm : object.messages().alarms())
    if (alarm.cause == Cause::Latched) latched[number++] = alarm.row->number;
  auto written = object.write(counter, 0, count);
  if (!written) return written;
  for (std::size_t i = 0; i < number; ++i) withdraw(object.number(), latched[i]);
  return written;
}

}  // namespace drive
