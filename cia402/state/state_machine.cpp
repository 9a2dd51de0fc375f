#include "cia402/state/state_machine.hpp"

namespace cia402 {
namespace {

constexpr unsigned kFaultReset = 0x0080;

}  // namespace

Outcome StateMachine::controlword(std::uint16_t word, const OptionCodes& codes, bool can_reset) noexcept {
  const bool rises = (word & ~word_ & kFaultReset) != 0;
  word_ = word;
  if (rises) return can_reset ? happen(Event::FaultReset, codes) : Outcome{};
  const std::optional<Event> command = command_of(word);
  return command ? happen(*command, codes) : Outcome{};
}

Outcome StateMachine::standstill_reached() noexcept {
  if (!is_braking()) return {};
  if (state_ == State::FaultReactionActive) return happen(Event::FaultReactionOver, {});
  if (state_ != State::QuickStopActive) return take_pulses_off(true);
  if (!stays_) return happen(Event::QuickStopOver, {});
  braking_ = Braking::None;
  return {};
}

/// An axis that still brakes is on power, whatever state it shows: it brakes on as from Operation enabled.
Outcome StateMachine::fault(const OptionCodes& codes, bool can_brake) noexcept {
  if (state_ == State::FaultReactionActive && !can_brake) return happen(Event::FaultReactionOver, codes);
  OptionCodes allowed = codes;
  if (!can_brake) allowed.fault_reaction = 0;
  const bool brakes_below = is_braking() && !is_on_power(state_);
  const State from = brakes_below ? State::OperationEnabled : state_;
  const Transition* const row = find_transition(from, Event::FaultOccurred);
  return row != nullptr ? carry_out(*row, allowed) : Outcome{};
}

Outcome StateMachine::happen(Event event, const OptionCodes& codes) noexcept {
  const Transition* const row = find_transition(state_, event);
  if (row == nullptr) return {};
  if (state_ == State::QuickStopActive && event == Event::EnableOperation && !stays_) return {};
  return carry_out(*row, codes);
}

Outcome StateMachine::carry_out(const Transition& row, const OptionCodes& codes) noexcept {
  const bool was_powered = is_powered();
  state_ = row.to;
  Outcome outcome{};
  switch (row.effect) {
    case Effect::None:
      break;
    case Effect::Enable:
      braking_ = Braking::None;
      outcome.action = Action::Enable;
      break;
    case Effect::PulsesOff:
      outcome = take_pulses_off(was_powered);
      break;
    case Effect::Stop:
      outcome = stop(row.cause, codes);
      break;
    case Effect::StopFurther:
      outcome = is_braking() ? stop(row.cause, codes) : take_pulses_off(was_powered);
      break;
  }
  const std::uint8_t second = outcome.transitions[0];
  outcome.transitions = row.numbers;
  if (second != 0) outcome.transitions[1] = second;
  return outcome;
}

/// Where no braking is wanted, the state of the braking is passed at once.
Outcome StateMachine::stop(StopCause cause, const OptionCodes& codes) noexcept {
  const StopRow& row = stop_of(cause, codes);
  if (row.braking != Braking::None) {
    braking_ = row.braking;
    stays_ = row.end == State::QuickStopActive;
    return {.action = Action::Brake, .braking = row.braking};
  }
  Outcome outcome = take_pulses_off(true);
  if (state_ == row.end) return outcome;
  const Event over = cause == StopCause::QuickStop ? Event::QuickStopOver : Event::FaultReactionOver;
  const Transition& passed = *find_transition(state_, over);
  state_ = passed.to;
  outcome.transitions = passed.numbers;
  return outcome;
}

Outcome StateMachine::take_pulses_off(bool were_on) noexcept {
  braking_ = Braking::None;
  return {.action = were_on ? Action::PulsesOff : Action::None};
}

}  // namespace cia402
