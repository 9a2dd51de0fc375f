#pragma once

#include <cstdint>

namespace cia402 {

/// Objects of an axis that act when they are received.
enum class Acting : std::uint8_t {
  Mode,           ///< 6060h
  Position,       ///< 607Ah, 60B0h
  Interpolation,  ///< 60C1h:1
  Velocity,       ///< 60FFh, 60B1h
  Torque,         ///< 6071h, 60B2h
  VlVelocity,     ///< 6042h
  Probe,          ///< 60B8h
  Controlword,    ///< 6040h
};
/// A set of them, a bit each.
using ActingSet = std::uint8_t;
constexpr ActingSet bit_of(Acting what) noexcept {
  return static_cast<ActingSet>(1U << static_cast<unsigned>(what));
}
constexpr bool contains(ActingSet set, Acting what) noexcept {
  return (set & bit_of(what)) != 0;
}

/// What the object @p index of the first axis does when it is received.
ActingSet acting_of(std::uint16_t index) noexcept;

}  // namespace cia402
