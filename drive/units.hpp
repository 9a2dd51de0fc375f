#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "motor/machine_data.hpp"

namespace drive {

using motor::kRpm;

/// Units in which parameters are shown and written.
enum class Unit : std::uint8_t {
  None,
  Rpm,
  Seconds,
  Milliseconds,
  NewtonMetre,
  NewtonMetreSecondPerRadian,
  KilogramSquareMetre,
  Bits,
};

/// A unit's text and its size in the SI unit that the drive computes with.
struct UnitRow {
  Unit unit;
  std::string_view text;
  double si;
};

/// One row a unit, in the order of the enumeration.
inline constexpr std::array kUnits{
    UnitRow{Unit::None, "", 1.0},
    UnitRow{Unit::Rpm, "rpm", motor::kRpm},
    UnitRow{Unit::Seconds, "s", 1.0},
    UnitRow{Unit::Milliseconds, "ms", 1e-3},
    UnitRow{Unit::NewtonMetre, "Nm", 1.0},
    UnitRow{Unit::NewtonMetreSecondPerRadian, "Nms/rad", 1.0},
    UnitRow{Unit::KilogramSquareMetre, "kgm²", 1.0},
    UnitRow{Unit::Bits, "bit", 1.0},
};

/// Text and factor of @p unit.
constexpr const UnitRow& row_of(Unit unit) noexcept {
  return kUnits[static_cast<std::size_t>(unit)];
}

static_assert([] {
  for (std::size_t i = 0; i < kUnits.size(); ++i)
    if (kUnits[i].unit != static_cast<Unit>(i)) return false;
  return true;
}());

}  // namespace drive
