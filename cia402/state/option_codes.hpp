#pragma once

#include <cstdint>
#include <span>

#include "cia402/state/state.hpp"

namespace cia402 {

/// How an axis comes to rest.
enum class Braking : std::uint8_t {
  None,           ///< pulses off at once, the motor coasts
  SlowDownRamp,   ///< 6084h
  QuickStopRamp,  ///< 6085h
  MaxTorque,      ///< as hard as the torque limits allow
};

/// What an axis comes to rest for.
enum class StopCause : std::uint8_t {
  QuickStop,         ///< 605Ah
  Shutdown,          ///< 605Bh
  DisableOperation,  ///< 605Ch
  Halt,              ///< 605Dh
  FaultReaction,     ///< 605Eh
};

/// A value of an option code.
struct StopRow {
  StopCause cause;
  std::int16_t code;
  Braking braking;
  State end;  ///< the state at rest
};

/// The option codes with their factory values.
struct OptionCodes {
  std::int16_t quick_stop = 2;         ///< 605Ah, 0..8
  std::int16_t shutdown = 0;           ///< 605Bh, 0, 1
  std::int16_t disable_operation = 1;  ///< 605Ch, 0, 1
  std::int16_t halt = 1;               ///< 605Dh, 1..4
  std::int16_t fault_reaction = 2;     ///< 605Eh, 0..4

  std::int16_t of(StopCause cause) const noexcept;
  friend bool operator==(const OptionCodes&, const OptionCodes&) = default;
};

/// All values of all option codes.
std::span<const StopRow> stop_rows() noexcept;
/// What the code for @p cause says; one that does not exist acts like the factory value.
const StopRow& stop_of(StopCause cause, const OptionCodes& codes) noexcept;

/// What a lost connection does (6007h).
enum class AbortReaction : std::uint8_t { None, Fault, DisableVoltage, QuickStop };
/// Abort connection option code (6007h, 0..3); others act like none.
constexpr AbortReaction abort_reaction(std::int16_t code) noexcept {
  return code >= 0 && code <= 3 ? static_cast<AbortReaction>(code) : AbortReaction::None;
}

}  // namespace cia402
