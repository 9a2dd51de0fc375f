#include "drive/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drive/statusword.hpp"
#include "motor/dc_link.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kConnectionAbort = 8700;
constexpr std::uint16_t kZeroMarkDistance = 31100;

constexpr std::int32_t kHaltWithPulsesOff = 0;

/// p8641 by value: the reaction to F08700.
constexpr std::array kAbortReactions{Reaction::None, Reaction::Off1, Reaction::Off2, Reaction::Off3};

struct ReactionRow {
  Reaction reaction;
  Event event;
};
constexpr std::array kReactionEvents{
    ReactionRow{Reaction::Off1, Event::FaultOff1},
    ReactionRow{Reaction::Off2, Event::FaultOff2},
    ReactionRow{Reaction::Off3, Event::FaultOff3},
    ReactionRow{Reaction::Encoder, Event::FaultOff2},  // p0491 of a new unit
    ReactionRow{Reaction::Stop2, Event::FaultOff3},
    ReactionRow{Reaction::ShortCircuit, Event::FaultOff2},
};

/// Bits 0 to 3 of a controlword from the inputs of the sequence control.
std::uint16_t sequence_word(const AxisInputs& inputs, bool pulses_allowed) noexcept {
  const std::array bits{inputs.on, inputs.no_off2 && inputs.no_off2_second,
                        inputs.no_off3 && inputs.no_off3_second, inputs.enable_operation && pulses_allowed};
  unsigned word = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) word |= static_cast<unsigned>(bits[i]) << i;
  return static_cast<std::uint16_t>(word);
}

}  // namespace

Axis::Axis(const AxisConfiguration& configuration, std::uint8_t module, std::uint8_t node_id,
           const motor::SupplyData& supply)
    : DriveObject{{.kind = configuration.kind,
                   .module = module,
                   .node_id = node_id,
                   .axis = configuration,
                   .supply = supply}},
      parameters_{commissioned_parameters(configuration)},
      train_{configuration.machine, configuration.load, configuration.inverter},
      counts_to_speed_{2.0 * std::numbers::pi / motor::increments_per_revolution(configuration.machine)},
      dc_voltage_{motor::DcLink{supply}.voltage()} {
  restore_parameters();
}

void Axis::sequence(const AxisInputs& inputs, double duration) noexcept {
  const bool acknowledgement = has_acknowledgement(wired_, inputs);
  take_inputs(inputs);
  if (apply(Event::Initialised)) return;
  if (acknowledgement) {
    const State before = state_;
    acknowledge();
    if (state_ != before) return;  // Switch on disabled is seen for a cycle, whatever else the word says
  }
  apply(command_of(command_word()));
  if (is_braking(state_)) check_standstill(duration);
}

/// The controlword as the sequence control sees it: none at all in commissioning, and a halt by option code 0 is a
/// missing operation enable.
std::uint16_t Axis::command_word() const noexcept {
  if (inhibited_ || parameters_.commissioning != 0) return 0;
  const bool pulses_off = halt_requested() && parameters_.halt_option == kHaltWithPulsesOff;
  return sequence_word(inputs_, !pulses_off);
}

/// Bit 8 of the controlword, where p8791 gives it a function.
bool Axis::halt_requested() const noexcept {
  constexpr std::uint16_t kHaltBit = 0x0100;
  return (inputs_.controlword & kHaltBit) != 0 && parameters_.halt_option >= 0;
}

void Axis::check_standstill(double duration) noexcept {
  const double closing_time = has_brake() ? context().axis.load.brake.closing_time : 0.0;
  const StandstillMonitor::Limits limits{parameters_.standstill_threshold, parameters_.standstill_monitoring_time,
                                         parameters_.pulse_suppression_delay + closing_time};
  if (standstill_.update(duration, actual_.speed, channel_.output(), limits)) apply(Event::Standstill);
}

bool Axis::apply(Event event) noexcept {
  const Transition* row = find_transition(state_, event);
  if (row == nullptr) return false;
  if (row->to != row->from) standstill_.restart();
  state_ = row->to;
  perform(row->action);
  return true;
}

void Axis::perform(Action action) noexcept {
  switch (action) {
    case Action::None:
      break;
    case Action::EnablePulses:
      channel_.start(train_.signals().measured_speed);
      break;
    case Action::InhibitPulses:
      channel_.start(0.0);
      break;
    case Action::FollowSetpoint:
      break;
    case Action::BrakeOnOff1:
      brake_on(Ramp::Off1);
      break;
    case Action::BrakeOnOff3:
      brake_on(Ramp::Off3);
      break;
  }
}

void Axis::brake_on(Ramp ramp) noexcept {
  channel_.brake(ramp, train_.signals().measured_speed);
}

void Axis::react(const FaultRow& row) noexcept {
  const bool abort = row.number == kConnectionAbort;
  const Reaction standard =
      abort ? kAbortReactions[static_cast<std::size_t>(parameters_.abort_connection_option)] : row.reaction;
  const Reaction reaction = messages().settings.reaction_to(row).value_or(standard);
  for (const ReactionRow& candidate : kReactionEvents)
    if (candidate.reaction == reaction) apply(candidate.event);
}

void Axis::refresh_status() noexcept {
  const bool pulses = pulses_enabled_in(state_);
  actual_.state = state_;
  actual_.pulses_enabled = pulses;
  actual_.speed_demand = channel_.total();
  actual_.mode = mode_.display(parameters_.control_mode);
  actual_.statusword =
      statusword(state_, {.no_off2 = inputs_.no_off2 && inputs_.no_off2_second,
                          .no_off3 = inputs_.no_off3 && inputs_.no_off3_second,
                          .fault = !messages().faults().empty(),
                          .alarm = !messages().alarms().empty(),
                          .target_reached = target_reached_,
                          .torque_limit_reached = pulses && train_.signals().torque_limit_reached,
                          .speed_zero = std::abs(actual_.speed) < parameters_.zero_speed_threshold});
}

bool Axis::is_quiescent() const noexcept {
  return settled_ && !pulses_enabled_in(state_) && train_.rests() && !causes_.any_present();
}

void Axis::power_off() noexcept {
  DriveObject::power_off();
  state_ = State::SwitchOnDisabled;
  perform(Action::InhibitPulses);
  wired_ = inputs_ = {};
  refresh_status();
  settled_ = false;
}

void Axis::on_messages_changed() noexcept {
  refresh_status();
  settled_ = false;
}

bool Axis::acknowledge() noexcept {
  if (state_ == State::FaultReactionActive) return false;
  // What the encoder has found is over with the acknowledgement; what is still wrong it finds again.
  train_.acknowledge_encoder();
  if (train_.encoder().status().zero_mark_deviation == 0) memory().withdraw(*find_fault(kZeroMarkDistance));
  const bool none_left = memory().acknowledge(pulses_enabled_in(state_));
  if (none_left) apply(Event::Acknowledged);
  on_messages_changed();
  return none_left;
}

void Axis::set_load_torque(double torque) noexcept {
  train_.set_load_torque(torque);
  settled_ = false;
}

void Axis::fail_encoder(motor::EncoderDefect defect) noexcept {
  train_.inject(defect);
  settled_ = false;
}

void Axis::inhibit(bool inhibited) noexcept {
  inhibited_ = inhibited;
  settled_ = false;
}

}  // namespace drive
