#include "drive/sequence_control/state_machine.hpp"

#include <algorithm>
#include <array>

namespace drive {
namespace {

using enum State;
using E = Event;
using A = Action;

constexpr std::array kTransitions{
    Transition{NotReadyToSwitchOn, E::Initialised, SwitchOnDisabled, A::None},
    Transition{NotReadyToSwitchOn, E::FaultOff1, Fault, A::None},
    Transition{NotReadyToSwitchOn, E::FaultOff2, Fault, A::None},
    Transition{NotReadyToSwitchOn, E::FaultOff3, Fault, A::None},
    Transition{NotReadyToSwitchOn, E::FaultStop2, Fault, A::None},

    // Only an OFF1 command (ON = 0) with OFF2 and OFF3 withdrawn lifts the inhibit: 0000h to 000Fh stays here.
    Transition{SwitchOnDisabled, E::Shutdown, ReadyToSwitchOn, A::None},
    Transition{SwitchOnDisabled, E::FaultOff1, Fault, A::None},
    Transition{SwitchOnDisabled, E::FaultOff2, Fault, A::None},
    Transition{SwitchOnDisabled, E::FaultOff3, Fault, A::None},
    Transition{SwitchOnDisabled, E::FaultStop2, Fault, A::None},

    // 0006h to 000Fh passes Switched on: the second step follows in the next cycle.
    Transition{ReadyToSwitchOn, E::SwitchOn, SwitchedOn, A::None},
    Transition{ReadyToSwitchOn, E::EnableOperation, SwitchedOn, A::None},
    Transition{ReadyToSwitchOn, E::DisableVoltage, SwitchOnDisabled, A::None},
    Transition{ReadyToSwitchOn, E::QuickStop, SwitchOnDisabled, A::None},
    Transition{ReadyToSwitchOn, E::FaultOff1, Fault, A::None},
    Transition{ReadyToSwitchOn, E::FaultOff2, Fault, A::None},
    Transition{ReadyToSwitchOn, E::FaultOff3, Fault, A::None},
    Transition{ReadyToSwitchOn, E::FaultStop2, Fault, A::None},

    Transition{SwitchedOn, E::Shutdown, ReadyToSwitchOn, A::None},
    Transition{SwitchedOn, E::EnableOperation, OperationEnabled, A::EnablePulses},
    Transition{SwitchedOn, E::DisableVoltage, SwitchOnDisabled, A::None},
    Transition{SwitchedOn, E::QuickStop, SwitchOnDisabled, A::None},
    Transition{SwitchedOn, E::FaultOff1, Fault, A::None},
    Transition{SwitchedOn, E::FaultOff2, Fault, A::None},
    Transition{SwitchedOn, E::FaultOff3, Fault, A::None},
    Transition{SwitchedOn, E::FaultStop2, Fault, A::None},

    Transition{OperationEnabled, E::Shutdown, Off1Braking, A::BrakeOnOff1},
    Transition{OperationEnabled, E::SwitchOn, SwitchedOn, A::InhibitPulses},
    Transition{OperationEnabled, E::DisableVoltage, SwitchOnDisabled, A::InhibitPulses},
    Transition{OperationEnabled, E::QuickStop, QuickStopActive, A::BrakeOnOff3},
    Transition{OperationEnabled, E::FaultOff1, FaultReactionActive, A::BrakeOnOff1},
    Transition{OperationEnabled, E::FaultOff2, Fault, A::InhibitPulses},
    Transition{OperationEnabled, E::FaultOff3, FaultReactionActive, A::BrakeOnOff3},
    Transition{OperationEnabled, E::FaultStop2, Stop2Active, A::BrakeOnOff3},
    Transition{OperationEnabled, E::MeasurementEnded, SwitchOnDisabled, A::InhibitPulses},

    Transition{Off1Braking, E::SwitchOn, SwitchedOn, A::InhibitPulses},
    Transition{Off1Braking, E::EnableOperation, OperationEnabled, A::FollowSetpoint},
    Transition{Off1Braking, E::DisableVoltage, SwitchOnDisabled, A::InhibitPulses},
    Transition{Off1Braking, E::QuickStop, QuickStopActive, A::BrakeOnOff3},
    Transition{Off1Braking, E::Standstill, ReadyToSwitchOn, A::InhibitPulses},
    Transition{Off1Braking, E::FaultOff1, FaultReactionActive, A::BrakeOnOff1},
    Transition{Off1Braking, E::FaultOff2, Fault, A::InhibitPulses},
    Transition{Off1Braking, E::FaultOff3, FaultReactionActive, A::BrakeOnOff3},
    // An OFF is on its way already: nothing is left to hold for.
    Transition{Off1Braking, E::FaultStop2, FaultReactionActive, A::BrakeOnOff3},

    // OFF3 cannot be cancelled; a fault with OFF1 does not soften it.
    Transition{QuickStopActive, E::DisableVoltage, SwitchOnDisabled, A::InhibitPulses},
    Transition{QuickStopActive, E::Standstill, SwitchOnDisabled, A::InhibitPulses},
    Transition{QuickStopActive, E::FaultOff1, FaultReactionActive, A::BrakeOnOff3},
    Transition{QuickStopActive, E::FaultOff2, Fault, A::InhibitPulses},
    Transition{QuickStopActive, E::FaultOff3, FaultReactionActive, A::BrakeOnOff3},
    Transition{QuickStopActive, E::FaultStop2, FaultReactionActive, A::BrakeOnOff3},

    Transition{FaultReactionActive, E::DisableVoltage, Fault, A::InhibitPulses},
    Transition{FaultReactionActive, E::QuickStop, FaultReactionActive, A::BrakeOnOff3},
    Transition{FaultReactionActive, E::Standstill, Fault, A::InhibitPulses},
    Transition{FaultReactionActive, E::FaultOff2, Fault, A::InhibitPulses},
    Transition{FaultReactionActive, E::FaultOff3, FaultReactionActive, A::BrakeOnOff3},
    Transition{FaultReactionActive, E::FaultStop2, FaultReactionActive, A::BrakeOnOff3},

    // Every OFF ends the holding; acknowledging comes after the braking only, see Axis::acknowledge().
    Transition{Stop2Active, E::Shutdown, FaultReactionActive, A::BrakeOnOff3},
    Transition{Stop2Active, E::DisableVoltage, Fault, A::InhibitPulses},
    Transition{Stop2Active, E::QuickStop, FaultReactionActive, A::BrakeOnOff3},
    Transition{Stop2Active, E::FaultOff1, FaultReactionActive, A::BrakeOnOff3},
    Transition{Stop2Active, E::FaultOff2, Fault, A::InhibitPulses},
    Transition{Stop2Active, E::FaultOff3, FaultReactionActive, A::BrakeOnOff3},
    Transition{Stop2Active, E::Acknowledged, SwitchOnDisabled, A::InhibitPulses},

    // ON still set after the acknowledgement keeps the drive in Switch on disabled, see there.
    Transition{Fault, E::Acknowledged, SwitchOnDisabled, A::None},
};

struct StateRow {
  State state;
  bool pulses;
  bool braking;
};
constexpr std::array<StateRow, kStateCount> kStates{{
    {NotReadyToSwitchOn, false, false},
    {SwitchOnDisabled, false, false},
    {ReadyToSwitchOn, false, false},
    {SwitchedOn, false, false},
    {OperationEnabled, true, false},
    {Off1Braking, true, true},
    {QuickStopActive, true, true},
    {FaultReactionActive, true, true},
    {Stop2Active, true, false},
    {Fault, false, false},
}};

struct CommandRow {
  std::uint16_t mask;
  std::uint16_t value;
  Event command;
};
constexpr std::array kCommands{
    CommandRow{0x0002, 0x0000, E::DisableVoltage},  CommandRow{0x0006, 0x0002, E::QuickStop},
    CommandRow{0x0007, 0x0006, E::Shutdown},        CommandRow{0x000F, 0x0007, E::SwitchOn},
    CommandRow{0x000F, 0x000F, E::EnableOperation},
};

/// The command that bits 0 to 3 of a controlword are.
constexpr std::array<Event, 16> kCommandOf = [] {
  std::array<Event, 16> table{};
  for (std::size_t word = 0; word < table.size(); ++word)
    for (const CommandRow& row : kCommands)
      if ((word & row.mask) == row.value) table[word] = row.command;
  return table;
}();

constexpr std::size_t index(State state) {
  return static_cast<std::size_t>(state);
}
constexpr std::size_t index(Event event) {
  return static_cast<std::size_t>(event);
}

using Lookup = std::array<std::array<const Transition*, kEventCount>, kStateCount>;
constexpr Lookup kLookup = [] {
  Lookup table{};
  for (const Transition& row : kTransitions) table[index(row.from)][index(row.on)] = &row;
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
      for (std::size_t i = 0; i < kStates.size(); ++i)
        if (index(kStates[i].state) != i) return false;
      return true;
    }(),
    "one row a state, in the order of the enumeration");

static_assert(
    [] {
      for (unsigned word = 0; word < 16; ++word) {
        int matching = 0;
        for (const CommandRow& row : kCommands) matching += (word & row.mask) == row.value ? 1 : 0;
        if (matching != 1) return false;
      }
      return true;
    }(),
    "every controlword carries exactly one command");

static_assert(
    [] {
      return std::all_of(kTransitions.begin(), kTransitions.end(), [](const Transition& row) {
        const bool changes = kStates[index(row.from)].pulses != kStates[index(row.to)].pulses;
        const bool switches = row.action == A::EnablePulses || row.action == A::InhibitPulses;
        return changes == switches;
      });
    }(),
    "the action switches the pulses exactly where the states differ");

}  // namespace

Event command_of(std::uint16_t controlword) noexcept {
  return kCommandOf[controlword & 0x000FU];
}

const Transition* find_transition(State state, Event event) noexcept {
  return kLookup[index(state)][index(event)];
}

std::span<const Transition> transitions() noexcept {
  return kTransitions;
}

bool pulses_enabled_in(State state) noexcept {
  return kStates[index(state)].pulses;
}

bool is_braking(State state) noexcept {
  return kStates[index(state)].braking;
}

}  // namespace drive
