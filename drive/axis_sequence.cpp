// The sequence control of an axis: what its inputs, its faults and the end of a braking make of its state.
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "drive/axis.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kHaltBit = 0x0100;
constexpr std::int32_t kHaltWithPulsesOff = 0;

constexpr std::uint16_t kPowerUnitNotReady = 7802;
constexpr std::uint16_t kInfeedMissing = 7840;
constexpr std::uint16_t kConnectionAbort = 8700;
constexpr std::uint16_t kZeroMarkDistance = 31100;

/// A message that lasts as long as an input is 0.
struct InputMessage {
  std::uint16_t number;
  bool AxisInputs::*signal;
  Pulses pulses;
};
constexpr std::array kInputMessages{
    InputMessage{7220, &AxisInputs::control_by_plc, Pulses::On},
    InputMessage{7841, &AxisInputs::infeed_operates, Pulses::On},
    InputMessage{7850, &AxisInputs::no_external_alarm_1, Pulses::Any},
    InputMessage{7860, &AxisInputs::no_external_fault_1, Pulses::Any},
    InputMessage{7861, &AxisInputs::no_external_fault_2, Pulses::Any},
    InputMessage{7862, &AxisInputs::no_external_fault_3, Pulses::Any},
};

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

const AbortRow& abort_row(const AxisParameters& parameters) noexcept {
  return kAbortOptions[static_cast<std::size_t>(parameters.abort_connection_option)];
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

/// Bits 0 to 3 of a controlword.
std::uint16_t sequence_word(bool on, const AxisInputs& inputs, bool enable) noexcept {
  const std::array bits{on, !inputs.has_off2(), !inputs.has_off3(), enable};
  unsigned word = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) word |= static_cast<unsigned>(bits[i]) << i;
  return static_cast<std::uint16_t>(word);
}

bool wants_jog(const AxisInputs& inputs) noexcept {
  return inputs.jog_1 || inputs.jog_2;
}

/// Whether an axis that was switched on by jog is still so in @p state.
bool keeps_jogging(State state) noexcept {
  return state == State::ReadyToSwitchOn || state == State::SwitchedOn || state == State::OperationEnabled;
}

}  // namespace

void Axis::sequence(double duration) noexcept {
  take_inputs();
  if (apply(Event::Initialised)) return;
  follow_inputs();
  if (has_acknowledgement(wired_before_, wired_)) {
    const State unacknowledged = state_;
    acknowledge();
    if (state_ != unacknowledged) return;  // Switch on disabled is seen for a cycle, whatever else the word says
  }
  follow_jog();
  apply(command_of(command_word()));
  wait_for_power(duration);
  if (is_braking(state_)) check_standstill(duration);
}

/// Messages by p0854, p0864, p2106 to p2108 and p2112.
void Axis::follow_inputs() noexcept {
  for (std::size_t i = 0; i < kInputMessages.size(); ++i) {
    const InputMessage& row = kInputMessages[i];
    const bool judged = row.pulses == Pulses::Any || pulses_enabled_in(state_);
    const bool present = judged && !(inputs_.*row.signal);
    const unsigned bit = 1U << i;
    if (present || (input_messages_ & bit) != 0) follow({row.number, present, 0});
    input_messages_ = present ? input_messages_ | bit : input_messages_ & ~bit;
  }
}

/// With ON = 0, the rising edge of a jog bit is ON and its 0 is OFF1.
void Axis::follow_jog() noexcept {
  const bool starts = wants_jog(inputs_) && !wants_jog(wired_before_) &&
                      (state_ == State::ReadyToSwitchOn || state_ == State::Off1Braking);
  const bool goes_on = jogging_ && wants_jog(inputs_) && keeps_jogging(state_);
  jogging_ = !inputs_.on && (starts || goes_on);
}

/// The controlword as the sequence control sees it: none at all in commissioning; a halt by option code 0 and an
/// infeed that does not operate yet are a missing operation enable.
std::uint16_t Axis::command_word() const noexcept {
  if (inhibited_ || parameters_.commissioning != 0) return 0;
  const bool halted = halt_requested() && parameters_.halt_option == kHaltWithPulsesOff;
  const bool waits = !pulses_enabled_in(state_) && !has_power();
  return sequence_word(inputs_.on || jogging_, inputs_, inputs_.enable_operation && !halted && !waits);
}

bool Axis::halt_requested() const noexcept {
  return (inputs_.controlword & kHaltBit) != 0 && parameters_.halt_option >= 0;
}

bool Axis::has_power() const noexcept {
  return inputs_.infeed_operates && dc_voltage_ >= context().supply.undervoltage;
}

/// F07840 or F07802, once, when infeed and DC link have not come within p0857 after ON.
void Axis::wait_for_power(double duration) noexcept {
  const double before = std::exchange(power_missing_, waits_for_power() ? power_missing_ + duration : 0.0);
  const double limit = parameters_.power_monitoring_time;
  if (elapsed(before, limit) || !elapsed(power_missing_, limit)) return;
  static_cast<void>(raise(inputs_.infeed_operates ? kPowerUnitNotReady : kInfeedMissing));
}

void Axis::check_standstill(double duration) noexcept {
  const double closing_time = has_brake() ? parameters_.brake_closing_time : 0.0;
  const StandstillMonitor::Limits limits{parameters_.standstill_threshold, parameters_.standstill_monitoring_time,
                                         parameters_.pulse_suppression_delay + closing_time};
  if (standstill_.update(duration, actual_.speed, channel_.output(), limits)) apply(Event::Standstill);
}

bool Axis::apply(Event event) noexcept {
  const Transition* row = find_transition(state_, event);
  if (row == nullptr) return false;
  if (row->to != row->from) standstill_.restart();
  state_ = row->to;
  if (identification_.leads() && state_ != State::OperationEnabled) stop_measurement();
  perform(row->action);
  return true;
}

void Axis::lose_connection() noexcept {
  const std::optional<Event> command = abort_row(parameters_).command;
  // Where nothing runs, OFF1 must not lift the inhibit; after OFF2 and OFF3 there is one, which ON alone does not.
  if (!command || state_ == State::SwitchOnDisabled) return;
  on_withheld_ = wired_.on && *command == Event::Shutdown;
  jogging_ = false;
  apply(*command);
  refresh_status();
  settled_ = false;
}

Reaction Axis::reaction_to(const FaultRow& row) const noexcept {
  const bool abort = row.number == kConnectionAbort;
  const Reaction standard = abort ? abort_row(parameters_).reaction : row.reaction;
  return messages().settings.reaction_to(row).value_or(standard);
}

void Axis::react(const FaultRow& row) noexcept {
  const Reaction reaction = reaction_to(row);
  const bool measured = identification_.leads();
  for (const ReactionRow& candidate : kReactionEvents)
    if (candidate.reaction == reaction) apply(candidate.event);
  if (measured && !identification_.leads()) cancel_identification();
}

Reactions Axis::active_reactions() const noexcept {
  unsigned reactions = 0;
  for (const FaultEntry& fault : messages().faults()) reactions |= bit_of(reaction_to(*fault.row));
  return static_cast<Reactions>(reactions);
}

bool Axis::stands() const noexcept {
  return std::abs(actual_.speed) < parameters_.standstill_threshold &&
         std::abs(channel_.output()) <= parameters_.standstill_threshold;
}

void Axis::on_acknowledged_fault_left() noexcept {
  if (messages().faults().empty()) apply(Event::Acknowledged);
}

bool Axis::acknowledge() noexcept {
  const bool brakes = state_ == State::FaultReactionActive || (state_ == State::Stop2Active && !stands());
  if (brakes) return false;
  // What the encoder has found is over with the acknowledgement; what is still wrong it finds again.
  train_.acknowledge_encoder();
  if (train_.encoder().status().zero_mark_deviation == 0) memory().withdraw(*find_fault(kZeroMarkDistance));
  const bool none_left = memory().acknowledge(pulses_enabled_in(state_));
  if (none_left) apply(Event::Acknowledged);
  on_messages_changed();
  return none_left;
}

}  // namespace drive
