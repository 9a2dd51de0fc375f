#include "drive/signal_source.hpp"

#include <cmath>
#include <optional>

#include "drive/base/scaling.hpp"
#include "drive/base/units.hpp"

namespace drive {
namespace {

constexpr double kWord = 0x4000;
constexpr double kDoubleWord = 0x40000000;
constexpr double kAnalogInput = 10.0;  // V
constexpr double kPerMille = 1000.0;

/// What of the quantity that @p row shows of @p object is 100 %, in the unit of the row, if anything is.
std::optional<double> full_scale_of_unit(const DriveObject& object, const ParameterRow& row) noexcept {
  const UnitRow& unit = row_of(row.unit);
  if (unit.quantity == Quantity::Share) return 1.0 / unit.si;
  const std::uint16_t number = reference_of(unit.quantity);
  const double value = number != 0 ? object.read(number).value_or(0.0) : 0.0;
  return value > 0.0 ? std::optional{value} : std::nullopt;
}

/// The same of any row.
std::optional<double> full_scale(const DriveObject& object, const ParameterRow& row) noexcept {
  const ProcessDataImage::Scales& scales = object.process_data().scales;
  switch (row.full_scale) {
    case FullScale::Word:
      return kWord;
    case FullScale::DoubleWord:
      return kDoubleWord;
    case FullScale::TargetVelocity:
      return reference(object, Quantity::Speed) * scales.increments_per_radian;
    case FullScale::TargetTorque:
      return kPerMille * reference(object, Quantity::Torque) / scales.rated_torque;
    case FullScale::AnalogInput:
      return kAnalogInput;
    case FullScale::OfUnit:
      break;
  }
  return full_scale_of_unit(object, row);
}

}  // namespace

double reference(const DriveObject& object, Quantity quantity) noexcept {
  if (quantity == Quantity::Share) return 1.0;
  const PlacedRow* const placed = find_parameter(object.kind(), reference_of(quantity));
  return placed != nullptr ? object.value(*placed, 0) * row_of(placed->row->unit).si : 0.0;
}

const DriveObject* connected_object(const DriveUnit& unit, const DriveObject& own,
                                    const BicoSource& source) noexcept {
  return source.object == kOwnObject ? &own : unit.object(source.object);
}

SignalSource::SignalSource(const DriveUnit& unit, const DriveObject& own, std::uint32_t packed) noexcept {
  if (packed <= kHighestConstant) {
    scale_ = packed;
    return;
  }
  const BicoSource source = unpack(packed);
  const DriveObject* const object = connected_object(unit, own, source);
  placed_ = object != nullptr ? find_parameter(object->kind(), source.number) : nullptr;
  if (placed_ == nullptr) return;
  object_ = object;
  index_ = source.position;
  unit_ = row_of(placed_->row->unit).si;
  (placed_->row->output == Output::Bits ? word_index_ : bit_) = source.position;
  const auto full = full_scale(*object, *placed_->row);
  is_quantity_ = full.has_value();
  scale_ = 1.0 / full.value_or(1.0);
  look_into(placed_->row->home);
}

/// A value that lies in a block is taken from there.
void SignalSource::look_into(const Home& home) noexcept {
  if (const auto* const setting = std::get_if<Setting>(&home)) {
    place_ = object_->block(setting->block);
    get_ = setting->get;
    conversion_ = Conversion::RoundedUnit;
  } else if (const auto* const output = std::get_if<BlockOutput>(&home)) {
    place_ = object_->block(output->block);
    get_ = output->get;
    conversion_ = Conversion::Unit;
  } else if (const auto* const computed = std::get_if<Computed>(&home)) {
    place_ = object_->block(computed->block);
    get_ = computed->get;
  }
}

void SignalSource::take_plain() noexcept {
  if (!is_constant()) scale_ = 1.0;
  is_quantity_ = true;
}

template <class Int>
Int SignalSource::process_data(double number) const noexcept {
  constexpr double kFull = sizeof(Int) == 2 ? kWord : kDoubleWord;
  if (is_quantity_) return saturated<Int>(value(number, kFull));
  return static_cast<Int>(static_cast<std::int64_t>(std::round(parameter(number))));
}
template std::int16_t SignalSource::process_data(double) const noexcept;
template std::int32_t SignalSource::process_data(double) const noexcept;

}  // namespace drive
