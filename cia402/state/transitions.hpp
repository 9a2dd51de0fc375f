#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "cia402/state/option_codes.hpp"
#include "cia402/state/state.hpp"

namespace cia402 {

/// What moves the state machine: a command of the controlword, or something that happened.
enum class Event : std::uint8_t {
  Shutdown,
  SwitchOn,  ///< in Operation enabled: disable operation
  EnableOperation,
  DisableVoltage,
  QuickStop,
  FaultReset,     ///< bit 7 has risen
  Initialised,    ///< the axis is ready
  QuickStopOver,  ///< it stands, and the option code does not hold it
  VoltageLost,    ///< of the DC link
  FaultOccurred,
  FaultReactionOver,  ///< it stands, or cannot brake
};
inline constexpr std::size_t kEventCount = 11;

/// The command in bits 7, 3, 2, 1 and 0 of @p controlword (6040h); none while bit 7 is set.
std::optional<Event> command_of(std::uint16_t controlword) noexcept;

/// What is done on a transition.
enum class Effect : std::uint8_t {
  None,
  Enable,  ///< pulses on, the mode begins
  PulsesOff,
  Stop,         ///< as the option code for the cause says
  StopFurther,  ///< the same if the axis still brakes since it left Operation enabled; otherwise pulses off
};

/// Numbers of the transitions that are passed (CiA 402: 1..16), in their order; 0 behind the last.
using TransitionNumbers = std::array<std::uint8_t, 2>;

/// A row of the transition table.
struct Transition {
  State from;
  Event on;
  TransitionNumbers numbers;
  State to;
  Effect effect;
  StopCause cause = StopCause::QuickStop;  ///< of a stop
};

/// All rows.
std::span<const Transition> transitions() noexcept;
/// The row for @p event in @p state, or nullptr: the event then changes nothing.
const Transition* find_transition(State state, Event event) noexcept;

}  // namespace cia402
