#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace drive {

/// What lies between the motor shaft and the load.
struct LoadMechanics {
  static constexpr std::uint32_t kMostRevolutions = 1048576;  ///< the limit of p2504 and p2505

  std::uint32_t gear_motor = 1;  ///< revolutions of the motor for gear_load of the load, 1..kMostRevolutions
  std::uint32_t gear_load = 1;   ///< 1..kMostRevolutions
  std::uint32_t pitch = 0;       ///< way of the load in a revolution of it (µm); 0: it turns and goes nowhere

  /// Revolutions of the motor for one of the load.
  constexpr double ratio() const noexcept {
    return static_cast<double>(gear_motor) / static_cast<double>(gear_load);
  }
};

/// A switch beside the way of the load, which is on from a place to another one and feeds a digital input.
struct TravelSwitch {
  unsigned input = 0;     ///< DI 0..7 of the control unit
  double from = 0.0;      ///< where it begins to be on (load revolutions from the place at power-on)
  double to = 0.0;        ///< where it is on no longer, above from
  bool inverted = false;  ///< off there, and on elsewhere
};

/// The switches of an axis, no two of a unit at one input.
struct TravelSwitchList {
  static constexpr std::size_t kMost = 8;

  std::array<TravelSwitch, kMost> switches{};
  std::size_t count = 0;

  constexpr std::span<const TravelSwitch> all() const noexcept { return {switches.data(), count}; }
  /// There is room for it.
  constexpr void add(const TravelSwitch& added) noexcept { switches[count++] = added; }
};

}  // namespace drive
