#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "libcanopen/base/nmt_state.hpp"

namespace device {

/// How a LED of the board shines (CiA 303-3, table "LED flash patterns"), as far as the unit uses it.
enum class LedPattern : std::uint8_t { Off, On, Blinking, SingleFlash, DoubleFlash };

/// Name of @p pattern as CiA 303-3 writes it.
constexpr std::string_view name_of(LedPattern pattern) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"off", "on", "blinking", "single flash", "double flash"};
  return kNames[static_cast<std::size_t>(pattern)];
}

/// The LEDs of the CANopen board.
struct IndicatorLeds {
  LedPattern run;    ///< green
  LedPattern error;  ///< red

  friend constexpr bool operator==(const IndicatorLeds&, const IndicatorLeds&) = default;
};

/// What the red LED tells of.
struct BusTrouble {
  bool off;            ///< bus-off
  bool guarding_lost;  ///< the life time of node guarding is over, and F08700 stands
  bool passive;        ///< A08752
};

/// The LEDs of a node in @p state; of several troubles the worst is shown.
constexpr IndicatorLeds leds_of(canopen::NmtState state, const BusTrouble& trouble) noexcept {
  const LedPattern run = state == canopen::NmtState::Operational      ? LedPattern::On
                         : state == canopen::NmtState::PreOperational ? LedPattern::Blinking
                         : state == canopen::NmtState::Stopped        ? LedPattern::SingleFlash
                                                                      : LedPattern::Off;
  const LedPattern error = trouble.off             ? LedPattern::On
                           : trouble.guarding_lost ? LedPattern::DoubleFlash
                           : trouble.passive       ? LedPattern::SingleFlash
                                                   : LedPattern::Off;
  return {run, error};
}

}  // namespace device
