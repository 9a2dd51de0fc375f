// What the transitions of the sequence control bring about, and how messages act on it.
#include <optional>

#include "drive/axis/axis.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kConnectionAbort = 8700;
constexpr std::uint16_t kZeroMarkDistance = 31100;

}  // namespace

bool Axis::apply(Event event) noexcept {
  const Transition* const row = block<SequenceControl>().apply(event);
  if (row == nullptr) return false;
  if (block<Identification>().leads() && row->to != State::OperationEnabled) stop_measurement();
  perform(row->action);
  return true;
}

void Axis::perform(Action action) noexcept {
  auto& identification = block<Identification>();
  const bool jogs = block<SequenceControl>().jogs();
  switch (action) {
    case Action::None:
      break;
    case Action::EnablePulses:
      block<SetpointChannel>().start(train_.signals().measured_speed);
      if (!jogs) identification.prepare(false);
      break;
    case Action::InhibitPulses:
      block<SetpointChannel>().start(0.0);
      break;
    case Action::FollowSetpoint:
      if (!jogs) identification.prepare(true);
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
  block<SetpointChannel>().brake(ramp, train_.signals().measured_speed);
}

bool Axis::has_brake() const noexcept {
  return block<HoldingBrake>().is_led(context().axis.load.brake.torque > 0.0);
}

bool Axis::stands() const noexcept {
  return block<SequenceControl>().is_standstill(actual_.speed, block<SetpointChannel>().output());
}

void Axis::follow(const Verdict& verdict) noexcept {
  if (!verdict.present && messages().faults().empty() && messages().alarms().empty()) return;
  const FaultRow* const row = find_fault(verdict.message);
  if (!verdict.present) return static_cast<void>(memory().withdraw(*row));
  enter(*row, verdict.value, Cause::Present);
}

void Axis::lose_connection() noexcept {
  if (block<OperatorPanel>().is_active()) return;
  const std::optional<Event> command = block<SequenceControl>().lose_connection();
  if (!command) return;
  apply(*command);
  refresh_status();
  settled_ = false;
}

Reaction Axis::reaction_to(const FaultRow& row) const noexcept {
  const bool abort = row.number == kConnectionAbort;
  const Reaction standard = abort ? block<SequenceControl>().abort_reaction() : standard_reaction(row);
  return messages().settings.reaction_to(row).value_or(standard);
}

void Axis::react(const FaultRow& row) noexcept {
  const bool measured = block<Identification>().leads();
  if (const std::optional<Event> event = event_of(reaction_to(row))) apply(*event);
  if (measured && !block<Identification>().leads()) cancel_identification();
}

Reactions Axis::active_reactions() const noexcept {
  unsigned reactions = 0;
  for (const FaultEntry& fault : messages().faults()) reactions |= bit_of(reaction_to(*fault.row));
  return static_cast<Reactions>(reactions);
}

void Axis::on_acknowledged_fault_left() noexcept {
  if (messages().faults().empty()) apply(Event::Acknowledged);
}

bool Axis::acknowledge() noexcept {
  const auto& sequence = block<SequenceControl>();
  const bool brakes =
      sequence.state() == State::FaultReactionActive || (sequence.state() == State::Stop2Active && !stands());
  if (brakes) return false;
  // What the encoder has found is over with the acknowledgement; what is still wrong it finds again.
  train_.acknowledge_encoder();
  if (train_.encoder().status().zero_mark_deviation == 0) memory().withdraw(*find_fault(kZeroMarkDistance));
  const bool none_left = memory().acknowledge(sequence.pulses_enabled());
  if (none_left) apply(Event::Acknowledged);
  on_messages_changed();
  return none_left;
}

void Axis::on_messages_changed() noexcept {
  refresh_status();
  settled_ = false;
}

void Axis::power_off() noexcept {
  DriveObject::power_off();
  if (block<Identification>().leads()) stop_measurement();
  block<Identification>().reset();
  block<SequenceControl>().power_off();
  block<OperatorPanel>().power_off();
  perform(Action::InhibitPulses);
  controlword_ = 0;
  block<ExternalMessages>().power_off();
  block<SpeedControl>().power_off();
  block<Jog>().power_off();
  block<SetpointChannel>().power_off();
  block<TorqueSetpoint>().inputs = {};
  block<SpeedSetpoint2>().inputs = {};
  block<ActualPosition>().inputs = {};
  block<Positioner>().power_off();
  block<PositionControl>().power_off();
  refresh_status();
  settled_ = false;
}

}  // namespace drive
