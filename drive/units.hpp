#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

namespace drive {

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
    UnitRow{Unit::Rpm, "rpm", 2.0 * std::numbers::pi / 60.0},
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

/// One revolution per minute (rad/s).
inline constexpr double kRpm = row_of(Unit::Rpm).si;

}  // namespace drive
