#pragma once

#include <cstdint>

#include "cia402/base/demand.hpp"
#include "cia402/state/state.hpp"

namespace cia402 {

/// What the statusword shows beside the state.
struct StatusSignals {
  bool has_voltage = false;      ///< bit 4, the DC link is charged
  bool has_warning = false;      ///< bit 7
  bool is_remote = false;        ///< bit 9, NMT state Operational
  bool is_limited = false;       ///< bit 11
  bool is_homed = false;         ///< bit 15
  ModeBits mode{};               ///< bits 10, 12, 13
  bool keeps_mode_bits = false;  ///< outside Operation enabled too (homing)
};

/// The statusword 6041h in @p state; bits 8 and 14 are 0.
std::uint16_t statusword(State state, const StatusSignals& signals) noexcept;

}  // namespace cia402
