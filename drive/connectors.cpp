#include "drive/connectors.hpp"

#include <algorithm>
#include <array>
#include <optional>

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

/// What of the parameter @p row of @p object is 100 %, if it is a quantity.
std::optional<double> full_scale(const DriveObject& object, const ParameterRow& row) noexcept {
  const auto data = std::ranges::find(kProcessData, row.number, &FullScaleRow::parameter);
  if (data != kProcessData.end()) return data->full;
  if (row.unit == Unit::Percent) return kPercent;
  if (row.unit == Unit::PerMille) return kPerMille;
  const auto reference = std::ranges::find(kReferences, row.unit, &ReferenceRow::unit);
  if (reference == kReferences.end()) return std::nullopt;
  const auto value = object.read(reference->parameter);
  return value && *value > 0.0 ? std::optional{*value} : std::nullopt;
}

}  // namespace

const DriveObject* connected_object(const DriveUnit& unit, const DriveObject& own,
                                    const BicoSource& source) noexcept {
  return source.object == kOwnObject ? &own : unit.object(source.object);
}

bool connected_bit(const DriveUnit& unit, const DriveObject& own, std::uint32_t packed) noexcept {
  if (packed <= kHighestConstant) return packed != 0;
  const BicoSource source = unpack(packed);
  const DriveObject* const object = connected_object(unit, own, source);
  const double word = object != nullptr ? object->read(source.number).value_or(0.0) : 0.0;
  return (static_cast<std::uint64_t>(static_cast<std::int64_t>(word)) >> source.position & 1) != 0;
}

double connected_value(const DriveUnit& unit, const DriveObject& own, std::uint32_t packed, double full) noexcept {
  if (packed <= kHighestConstant) return packed * full;
  const BicoSource source = unpack(packed);
  const DriveObject* const object = connected_object(unit, own, source);
  const PlacedRow* const placed = object != nullptr ? find_parameter(object->kind(), source.number) : nullptr;
  if (placed == nullptr) return 0.0;
  const double value = object->read(source.number, source.position).value_or(0.0);
  const auto scale = full_scale(*object, *placed->row);
  return scale ? value / *scale * full : value;
}

}  // namespace drive
