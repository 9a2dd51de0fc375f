#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace drive {

/// What a unit measures.
enum class Quantity : std::uint8_t {
  None,            ///< a number, a time, anything that no reference belongs to
  Share,           ///< percent and per mille, which are their own 100 %
  Length,          ///< in LU, as they are
  LengthVelocity,  ///< in 1000 LU/min, as they are
  Word,            ///< a word whose bits count, as it is
  Speed,
  Voltage,
  Current,
  Torque,
  Power,
  Angle,
  Temperature,
  Acceleration,
};

/// A quantity and the parameter that is 100 % of it where it comes from a connector or goes to a connector input.
struct QuantityRow {
  Quantity quantity = Quantity::None;
  std::uint16_t reference = 0;  ///< in the unit of the parameter; 0 = a connector brings the number as it is
  /// Of one that a connector input takes as the number that it is, whatever that is 100 % of where it comes from:
  /// what 1 is in SI units (LU, LU/s); 0: it takes a share of the reference.
  double of_one = 0.0;
};

/// One row a quantity, in the order of the enumeration.
inline constexpr std::array kQuantities{
    QuantityRow{Quantity::None, 0},
    QuantityRow{Quantity::Share, 0},
    QuantityRow{Quantity::Length, 0, 1.0},
    QuantityRow{Quantity::LengthVelocity, 0, 1000.0 / 60.0},
    QuantityRow{Quantity::Word, 0, 1.0},
    QuantityRow{Quantity::Speed, 2000},
    QuantityRow{Quantity::Voltage, 2001},
    QuantityRow{Quantity::Current, 2002},
    QuantityRow{Quantity::Torque, 2003},
    QuantityRow{Quantity::Power, 2004},
    QuantityRow{Quantity::Angle, 2005},
    QuantityRow{Quantity::Temperature, 2006},
    QuantityRow{Quantity::Acceleration, 2007},
};
static_assert([] {
  for (std::size_t i = 0; i < kQuantities.size(); ++i)
    if (kQuantities[i].quantity != static_cast<Quantity>(i)) return false;
  return true;
}());

/// The row of @p quantity.
constexpr const QuantityRow& row_of(Quantity quantity) noexcept {
  return kQuantities[static_cast<std::size_t>(quantity)];
}

/// The parameter that is 100 % of @p quantity, 0 if none is.
constexpr std::uint16_t reference_of(Quantity quantity) noexcept {
  return row_of(quantity).reference;
}

/// Whether parameter @p number is 100 % of a quantity.
constexpr bool is_reference(std::uint16_t number) noexcept {
  return number != 0 &&
         std::ranges::any_of(kQuantities, [=](const QuantityRow& row) { return row.reference == number; });
}

}  // namespace drive
