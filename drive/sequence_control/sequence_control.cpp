#include "drive/sequence_control/sequence_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace drive {
namespace {

constexpr std::int32_t kHaltWithPulsesOff = 0;
constexpr std::uint16_t kPowerUnitNotReady = 7802;
constexpr std::uint16_t kInfeedMissing = 7840;

/// What p8641 makes of a lost connection, by its value.
struct AbortRow {
  Reaction reaction{};           ///< to F08700
  std::optional<Event> command;  ///< the same without a fault
};
constexpr std::array kAbortOptions{
    AbortRow{Reaction::None, std::nullopt},
    AbortRow{Reaction::Off1, Event::Shutdown},
    AbortRow{Reaction::Off2, Event::DisableVoltage},
    AbortRow{Reaction::Off3, Event::QuickStop},
};

const AbortRow& abort_row(const SequenceControl::Settings& settings) noexcept {
  return kAbortOptions[static_cast<std::size_t>(settings.abort_connection_option)];
}

struct ReactionRow {
  Reaction reaction;
  Event event;
};
constexpr std::array kReactionEvents{
    ReactionRow{Reaction::Off1, Event::FaultOff1},
    ReactionRow{Reaction::Off2, Event::FaultOff2},
    ReactionRow{Reaction::Off3, Event::FaultOff3},
    ReactionRow{Reaction::Encoder, Event::FaultOff2},  // p0491 of a new unit
    ReactionRow{Reaction::Stop2, Event::FaultStop2},
    ReactionRow{Reaction::ShortCircuit, Event::FaultOff2},
};

/// Whether an axis that was switched on by jog is still so in @p state.
bool keeps_jogging(State state) noexcept {
  return state == State::SwitchedOn || state == State::OperationEnabled;
}

}  // namespace

std::optional<Event> event_of(Reaction reaction) noexcept {
  const auto* const row = std::ranges::find(kReactionEvents, reaction, &ReactionRow::reaction);
  return row != kReactionEvents.end() ? std::optional{row->event} : std::nullopt;
}

void SequenceControl::begin_cycle(std::optional<bool> panel_on) noexcept {
  in_ = panel_on ? Inputs{.on = *panel_on, .infeed_operates = inputs.infeed_operates} : inputs;
  on_withheld_ = on_withheld_ && in_.on && !in_.has_off2() && !in_.has_off3();
  on_ = in_.on && !on_withheld_;
}

void SequenceControl::follow_jog(bool jog, bool jogged) noexcept {
  const bool starts = jog && !jogged && (state_ == State::ReadyToSwitchOn || state_ == State::Off1Braking);
  const bool goes_on = jogging_ && jog && keeps_jogging(state_);
  jogging_ = !on_ && (starts || goes_on);
}

const Transition* SequenceControl::apply(Event event) noexcept {
  const Transition* const row = find_transition(state_, event);
  if (row == nullptr) return nullptr;
  if (row->to != row->from) standstill_.restart();
  state_ = row->to;
  return row;
}

Event SequenceControl::command(bool link) const noexcept {
  if (is_inhibited()) return command_of(0);
  const bool halted = halts() && settings.halt_option == kHaltWithPulsesOff;
  const bool waits = !pulses_enabled() && !has_power(link);
  const std::array bits{on_ || jogging_, !in_.has_off2(), !in_.has_off3(),
                        in_.enable_operation && !halted && !waits};
  unsigned word = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) word |= static_cast<unsigned>(bits[i]) << i;
  return command_of(static_cast<std::uint16_t>(word));
}

std::optional<std::uint16_t> SequenceControl::await_power(bool link, double duration) noexcept {
  const double before = std::exchange(power_missing_, waits_for_power(link) ? power_missing_ + duration : 0.0);
  const double limit = settings.power_monitoring_time;
  if (elapsed(before, limit) || !elapsed(power_missing_, limit)) return std::nullopt;
  return in_.infeed_operates ? kPowerUnitNotReady : kInfeedMissing;
}

bool SequenceControl::brakes_to_standstill(double duration, double speed, double setpoint,
                                           double closing_time) noexcept {
  return standstill_.update(duration, speed, setpoint,
                            {settings.standstill_threshold, settings.standstill_monitoring_time,
                             settings.pulse_suppression_delay + closing_time});
}

bool SequenceControl::is_standstill(double speed, double setpoint) const noexcept {
  return std::abs(speed) < settings.standstill_threshold && std::abs(setpoint) <= settings.standstill_threshold;
}

std::optional<Event> SequenceControl::lose_connection() noexcept {
  const std::optional<Event> command = abort_row(settings).command;
  // Where nothing runs, OFF1 must not lift the inhibit; after OFF2 and OFF3 there is one, which ON alone does not.
  if (!command || state_ == State::SwitchOnDisabled) return std::nullopt;
  on_withheld_ = in_.on && *command == Event::Shutdown;
  jogging_ = false;
  return command;
}

Reaction SequenceControl::abort_reaction() const noexcept {
  return abort_row(settings).reaction;
}

void SequenceControl::power_off() noexcept {
  state_ = State::SwitchOnDisabled;
  in_ = inputs = {};
  on_ = false;
  on_withheld_ = false;
}

}  // namespace drive
