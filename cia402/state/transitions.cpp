#include "cia402/state/transitions.hpp"

#include <cstddef>

namespace cia402 {
namespace {

using enum State;
using C = StopCause;
using E = Event;
using F = Effect;
using N = TransitionNumbers;

/// A pattern of the controlword.
struct CommandRow {
  std::uint16_t mask;
  std::uint16_t value;
  Event command;
};
// clang-format off
constexpr std::array kCommands{
    //         bit 7 3210
    CommandRow{0b1000'0111, 0b0000'0110, E::Shutdown},
    CommandRow{0b1000'1111, 0b0000'0111, E::SwitchOn},
    CommandRow{0b1000'1111, 0b0000'1111, E::EnableOperation},
    CommandRow{0b1000'0010, 0b0000'0000, E::DisableVoltage},
    CommandRow{0b1000'0110, 0b0000'0010, E::QuickStop},
};

constexpr std::array kTransitions{
    // 0 is the start of the program; until 1 nothing but a fault counts.
    Transition{NotReadyToSwitchOn,  E::Initialised,       N{1},      SwitchOnDisabled,    F::None},
    Transition{NotReadyToSwitchOn,  E::FaultOccurred,     N{13, 14}, Fault,               F::PulsesOff},

    Transition{SwitchOnDisabled,    E::Shutdown,          N{2},      ReadyToSwitchOn,     F::None},
    // Without a number: an axis that left Operation enabled may still brake in the states below it.
    Transition{SwitchOnDisabled,    E::DisableVoltage,    N{},       SwitchOnDisabled,    F::PulsesOff},
    Transition{SwitchOnDisabled,    E::VoltageLost,       N{},       SwitchOnDisabled,    F::PulsesOff},
    Transition{SwitchOnDisabled,    E::FaultOccurred,     N{13, 14}, Fault,               F::PulsesOff},

    Transition{ReadyToSwitchOn,     E::SwitchOn,          N{3},      SwitchedOn,          F::None},
    Transition{ReadyToSwitchOn,     E::EnableOperation,   N{3, 4},   OperationEnabled,    F::Enable},
    Transition{ReadyToSwitchOn,     E::DisableVoltage,    N{7},      SwitchOnDisabled,    F::PulsesOff},
    Transition{ReadyToSwitchOn,     E::QuickStop,         N{7},      SwitchOnDisabled,    F::StopFurther, C::QuickStop},
    Transition{ReadyToSwitchOn,     E::VoltageLost,       N{},       ReadyToSwitchOn,     F::PulsesOff},
    Transition{ReadyToSwitchOn,     E::FaultOccurred,     N{13, 14}, Fault,               F::PulsesOff},

    Transition{SwitchedOn,          E::Shutdown,          N{6},      ReadyToSwitchOn,     F::None},
    Transition{SwitchedOn,          E::EnableOperation,   N{4},      OperationEnabled,    F::Enable},
    Transition{SwitchedOn,          E::DisableVoltage,    N{10},     SwitchOnDisabled,    F::PulsesOff},
    Transition{SwitchedOn,          E::QuickStop,         N{10},     SwitchOnDisabled,    F::StopFurther, C::QuickStop},
    Transition{SwitchedOn,          E::VoltageLost,       N{10},     SwitchOnDisabled,    F::PulsesOff},
    Transition{SwitchedOn,          E::FaultOccurred,     N{13, 14}, Fault,               F::PulsesOff},

    Transition{OperationEnabled,    E::Shutdown,          N{8},      ReadyToSwitchOn,     F::Stop, C::Shutdown},
    Transition{OperationEnabled,    E::SwitchOn,          N{5},      SwitchedOn,          F::Stop, C::DisableOperation},
    Transition{OperationEnabled,    E::DisableVoltage,    N{9},      SwitchOnDisabled,    F::PulsesOff},
    Transition{OperationEnabled,    E::QuickStop,         N{11},     QuickStopActive,     F::Stop, C::QuickStop},
    Transition{OperationEnabled,    E::VoltageLost,       N{9},      SwitchOnDisabled,    F::PulsesOff},
    Transition{OperationEnabled,    E::FaultOccurred,     N{13},     FaultReactionActive, F::Stop, C::FaultReaction},

    // 16 is for the option codes that stay here; with the others the stop goes on to its end.
    Transition{QuickStopActive,     E::EnableOperation,   N{16},     OperationEnabled,    F::Enable},
    Transition{QuickStopActive,     E::DisableVoltage,    N{12},     SwitchOnDisabled,    F::PulsesOff},
    Transition{QuickStopActive,     E::QuickStopOver,     N{12},     SwitchOnDisabled,    F::PulsesOff},
    Transition{QuickStopActive,     E::VoltageLost,       N{12},     SwitchOnDisabled,    F::PulsesOff},
    Transition{QuickStopActive,     E::FaultOccurred,     N{13},     FaultReactionActive, F::Stop, C::FaultReaction},

    Transition{FaultReactionActive, E::FaultReactionOver, N{14},     Fault,               F::PulsesOff},
    Transition{FaultReactionActive, E::VoltageLost,       N{14},     Fault,               F::PulsesOff},

    Transition{Fault,               E::FaultReset,        N{15},     SwitchOnDisabled,    F::None},
};
// clang-format on

using Lookup = std::array<std::array<const Transition*, kEventCount>, kStateCount>;
constexpr Lookup kLookup = [] {
  Lookup table{};
  for (const Transition& row : kTransitions)
    table[static_cast<std::size_t>(row.from)][static_cast<std::size_t>(row.on)] = &row;
  return table;
}();

static_assert(
    [] {
      std::size_t filled = 0;
      for (const auto& events : kLookup)
        for (const Transition* row : events) filled += row != nullptr ? 1U : 0U;
      return filled == kTransitions.size();
    }(),
    "two rows for the same state and event");

static_assert(
    [] {
      for (unsigned word = 0; word < 0x80; ++word) {
        int matching = 0;
        for (const CommandRow& row : kCommands) matching += (word & row.mask) == row.value ? 1 : 0;
        if (matching != 1) return false;
      }
      return true;
    }(),
    "every controlword without bit 7 carries exactly one command");

}  // namespace

std::optional<Event> command_of(std::uint16_t controlword) noexcept {
  for (const CommandRow& row : kCommands)
    if ((controlword & row.mask) == row.value) return row.command;
  return std::nullopt;
}

std::span<const Transition> transitions() noexcept {
  return kTransitions;
}

const Transition* find_transition(State state, Event event) noexcept {
  return kLookup[static_cast<std::size_t>(state)][static_cast<std::size_t>(event)];
}

}  // namespace cia402
