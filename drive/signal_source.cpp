#include "drive/signal_source.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "drive/scaling.hpp"
#include "drive/units.hpp"

namespace drive {
namespace {

/// The parameter that is 100 % of quantities with a unit.
struct ReferenceRow {
  Unit unit;
  std::uint16_t parameter;
};
constexpr std::array kReferences{
    ReferenceRow{Unit::Rpm, 2000},       ReferenceRow{Unit::VoltsRms, 2001},
    ReferenceRow{Unit::Volts, 2001},     ReferenceRow{Unit::AmperesRms, 2002},
    ReferenceRow{Unit::Amperes, 2002},   ReferenceRow{Unit::NewtonMetre, 2003},
    ReferenceRow{Unit::Kilowatts, 2004}, ReferenceRow{Unit::Degrees, 2005},
    ReferenceRow{Unit::Celsius, 2006},   ReferenceRow{Unit::RevolutionsPerSecondSquared, 2007},
};

/// Parameters and units whose 100 % is a number.
struct FullScaleRow {
  std::uint16_t parameter;
  double full;
};
constexpr double kWord = 0x4000;
constexpr double kDoubleWord = 0x40000000;
constexpr std::array kProcessData{FullScaleRow{8745, kWord}, FullScaleRow{8747, kDoubleWord},
                                  FullScaleRow{8850, kWord}, FullScaleRow{8860, kDoubleWord}};
constexpr double kPercent = 100.0;
constexpr double kPerMille = 1000.0;
constexpr std::uint16_t kWrittenVelocity = 8796;
constexpr std::uint16_t kWrittenTorque = 8797;
constexpr std::uint16_t kReferenceSpeed = 2000;
constexpr std::uint16_t kReferenceTorque = 2003;

double parameter(const DriveObject& object, std::uint16_t number) noexcept {
  return object.read(number).value_or(0.0);
}

/// What of the parameter @p row of @p object is 100 %, if it is a quantity.
std::optional<double> full_scale(const DriveObject& object, const ParameterRow& row) noexcept {
  const auto* const data = std::ranges::find(kProcessData, row.number, &FullScaleRow::parameter);
  if (data != kProcessData.end()) return data->full;
  if (row.number == kWrittenVelocity)
    return parameter(object, kReferenceSpeed) * kRpm * object.process_data().scales.increments_per_radian;
  if (row.number == kWrittenTorque)
    return kPerMille * parameter(object, kReferenceTorque) / object.process_data().scales.rated_torque;
  if (row.unit == Unit::Percent) return kPercent;
  if (row.unit == Unit::PerMille) return kPerMille;
  const auto* const reference = std::ranges::find(kReferences, row.unit, &ReferenceRow::unit);
  if (reference == kReferences.end()) return std::nullopt;
  const double value = parameter(object, reference->parameter);
  return value > 0.0 ? std::optional{value} : std::nullopt;
}

}  // namespace

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
  position_ = source.position;
  const auto full = full_scale(*object, *placed_->row);
  is_quantity_ = full.has_value();
  scale_ = 1.0 / full.value_or(1.0);
}

bool SignalSource::bit() const noexcept {
  if (is_constant()) return scale_ > 0.0;
  if (has_a_bit_per_index(*placed_->row)) return object_->value(*placed_, position_) > 0.0;
  const auto word = static_cast<std::int64_t>(object_->value(*placed_, 0));
  return (word >> position_ & 1) != 0;
}

double SignalSource::value(double full) const noexcept {
  if (is_constant()) return scale_ * full;
  const double value = object_->value(*placed_, position_);
  return is_quantity_ ? value * scale_ * full : value;
}

template <class Int>
Int SignalSource::process_data() const noexcept {
  constexpr double kFull = sizeof(Int) == 2 ? kWord : kDoubleWord;
  if (is_quantity_) return saturated<Int>(value(kFull));
  return static_cast<Int>(static_cast<std::int64_t>(object_->value(*placed_, position_)));
}
template std::int16_t SignalSource::process_data() const noexcept;
template std::int32_t SignalSource::process_data() const noexcept;

}  // namespace drive
