// The state machine of CiA 402 against the transitions of the standard (CiA 402-2, 8.2), by words and events in
// any order.
#include <array>

#include <rapidcheck/gtest.h>

#include "cia402/state/state_machine.hpp"

namespace cia402 {
namespace {

bool is_transition(State from, std::uint8_t number, State to) {
  using enum State;
  switch (number) {
    case 1:
      return from == NotReadyToSwitchOn && to == SwitchOnDisabled;
    case 2:
      return from == SwitchOnDisabled && to == ReadyToSwitchOn;
    case 3:
      return from == ReadyToSwitchOn && to == SwitchedOn;
    case 4:
      return from == SwitchedOn && to == OperationEnabled;
    case 5:
      return from == OperationEnabled && to == SwitchedOn;
    case 6:
      return from == SwitchedOn && to == ReadyToSwitchOn;
    case 7:
      return from == ReadyToSwitchOn && to == SwitchOnDisabled;
    case 8:
      return from == OperationEnabled && to == ReadyToSwitchOn;
    case 9:
      return from == OperationEnabled && to == SwitchOnDisabled;
    case 10:
      return from == SwitchedOn && to == SwitchOnDisabled;
    case 11:
      return from == OperationEnabled && to == QuickStopActive;
    case 12:
      return from == QuickStopActive && to == SwitchOnDisabled;
    case 13:
      return from != Fault && from != FaultReactionActive && to == FaultReactionActive;
    case 14:
      return from == FaultReactionActive && to == Fault;
    case 15:
      return from == Fault && to == SwitchOnDisabled;
    case 16:
      return from == QuickStopActive && to == OperationEnabled;
    default:
      return false;
  }
}

constexpr std::array<State, 17> kEnds{
    State::NotReadyToSwitchOn, State::SwitchOnDisabled,    State::ReadyToSwitchOn,
    State::SwitchedOn,         State::OperationEnabled,    State::SwitchedOn,
    State::ReadyToSwitchOn,    State::SwitchOnDisabled,    State::ReadyToSwitchOn,
    State::SwitchOnDisabled,   State::SwitchOnDisabled,    State::QuickStopActive,
    State::SwitchOnDisabled,   State::FaultReactionActive, State::Fault,
    State::SwitchOnDisabled,   State::OperationEnabled};

/// Where @p outcome leads from @p state, by transitions that there are.
State followed(State state, const Outcome& outcome) {
  for (const std::uint8_t number : outcome.transitions) {
    if (number == 0) break;
    RC_ASSERT(number < kEnds.size());
    RC_ASSERT(is_transition(state, number, kEnds[number]));
    state = kEnds[number];
  }
  return state;
}

OptionCodes drawn_codes() {
  return {.quick_stop = static_cast<std::int16_t>(*rc::gen::inRange(0, 9)),
          .shutdown = static_cast<std::int16_t>(*rc::gen::inRange(0, 2)),
          .disable_operation = static_cast<std::int16_t>(*rc::gen::inRange(0, 2)),
          .halt = static_cast<std::int16_t>(*rc::gen::inRange(1, 5)),
          .fault_reaction = static_cast<std::int16_t>(*rc::gen::inRange(0, 5))};
}

Outcome drawn_step(StateMachine& machine, const OptionCodes& codes) {
  constexpr std::array<std::uint16_t, 12> kWords{0x00, 0x02, 0x06, 0x07, 0x0F,   0x0D,
                                                 0x0B, 0x80, 0x8F, 0x86, 0x010F, 0x1F};
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return machine.standstill_reached();
    case 1:
      return machine.fault(codes, *rc::gen::arbitrary<bool>());
    case 2:
      return machine.fault_reaction_over();
    case 3:
      return machine.voltage_lost();
    case 4:
      return machine.initialised();
    default:
      return machine.controlword(*rc::gen::elementOf(kWords), codes, *rc::gen::arbitrary<bool>());
  }
}

RC_GTEST_PROP(StateWalk, PassesTransitionsOfTheStandardAlone, ()) {
  StateMachine machine;
  const OptionCodes codes = drawn_codes();
  const auto steps = *rc::gen::inRange(1, 200);
  for (int i = 0; i < steps; ++i) {
    const State before = machine.state();
    const bool was_powered = machine.is_powered();
    const Outcome outcome = drawn_step(machine, codes);
    RC_ASSERT(followed(before, outcome) == machine.state());
    if (machine.state() == State::SwitchOnDisabled || machine.state() == State::Fault)
      RC_ASSERT(!machine.is_powered() || machine.is_braking());
    if (machine.state() == State::OperationEnabled) RC_ASSERT(machine.is_powered());
    if (outcome.action == Action::PulsesOff) RC_ASSERT(!machine.is_powered());
    if (!was_powered && machine.is_powered()) RC_ASSERT(outcome.action == Action::Enable);
  }
}

}  // namespace
}  // namespace cia402
