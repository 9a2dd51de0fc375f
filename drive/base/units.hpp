#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "drive/base/quantity.hpp"
#include "motor/data/machine_data.hpp"

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
  Kilograms,
  Bits,
  Microseconds,
  Percent,
  PerMille,
  Hertz,
  Kilohertz,
  Volts,
  VoltsRms,
  VoltsOrMilliamperes,
  Amperes,
  AmperesRms,
  NewtonMetrePerAmpere,
  Ohms,
  Millihenries,
  Kilowatts,
  KilowattHours,
  WattHours,
  Celsius,
  Degrees,
  RevolutionsPerSecondSquared,
  ThousandPerMinute,
  Increments,
  LengthUnits,
  ThousandLengthUnitsPerMinute,
  ThousandLengthUnitsPerSecondSquared,
  ThousandLengthUnitsPerSecondCubed,
};

/// A unit's text, its size in SI units and what it measures; lengths are in LU, temperatures stay in °C.
struct UnitRow {
  Unit unit;
  std::string_view text;
  double si;
  Quantity quantity = Quantity::None;
};

/// One row a unit, in the order of the enumeration.
inline constexpr std::array kUnits{
    UnitRow{Unit::None, "", 1.0},
    UnitRow{Unit::Rpm, "rpm", motor::kRpm, Quantity::Speed},
    UnitRow{Unit::Seconds, "s", 1.0},
    UnitRow{Unit::Milliseconds, "ms", 1e-3},
    UnitRow{Unit::NewtonMetre, "Nm", 1.0, Quantity::Torque},
    UnitRow{Unit::NewtonMetreSecondPerRadian, "Nms/rad", 1.0},
    UnitRow{Unit::KilogramSquareMetre, "kgm²", 1.0},
    UnitRow{Unit::Kilograms, "kg", 1.0},
    UnitRow{Unit::Bits, "bit", 1.0},
    UnitRow{Unit::Microseconds, "µs", 1e-6},
    UnitRow{Unit::Percent, "%", 0.01, Quantity::Share},
    UnitRow{Unit::PerMille, "‰", 1e-3, Quantity::Share},
    UnitRow{Unit::Hertz, "Hz", 1.0},
    UnitRow{Unit::Kilohertz, "kHz", 1e3},
    UnitRow{Unit::Volts, "V", 1.0, Quantity::Voltage},
    UnitRow{Unit::VoltsRms, "Vrms", 1.0, Quantity::Voltage},
    UnitRow{Unit::VoltsOrMilliamperes, "V or mA", 1.0},
    UnitRow{Unit::Amperes, "A", 1.0, Quantity::Current},
    UnitRow{Unit::AmperesRms, "Arms", 1.0, Quantity::Current},
    UnitRow{Unit::NewtonMetrePerAmpere, "Nm/A", 1.0},
    UnitRow{Unit::Ohms, "Ω", 1.0},
    UnitRow{Unit::Millihenries, "mH", 1e-3},
    UnitRow{Unit::Kilowatts, "kW", 1e3, Quantity::Power},
    UnitRow{Unit::KilowattHours, "kWh", 3.6e6},
    UnitRow{Unit::WattHours, "Wh", 3600.0},
    UnitRow{Unit::Celsius, "°C", 1.0, Quantity::Temperature},
    UnitRow{Unit::Degrees, "°", std::numbers::pi / 180.0, Quantity::Angle},
    UnitRow{Unit::RevolutionsPerSecondSquared, "rev/s²", 2.0 * std::numbers::pi, Quantity::Acceleration},
    UnitRow{Unit::ThousandPerMinute, "1000/min", 1000.0 / 60.0},
    UnitRow{Unit::Increments, "inc", 1.0},
    UnitRow{Unit::LengthUnits, "LU", 1.0, Quantity::Length},
    UnitRow{Unit::ThousandLengthUnitsPerMinute, "1000 LU/min", 1000.0 / 60.0},
    UnitRow{Unit::ThousandLengthUnitsPerSecondSquared, "1000 LU/s²", 1000.0},
    UnitRow{Unit::ThousandLengthUnitsPerSecondCubed, "1000 LU/s³", 1000.0},
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
