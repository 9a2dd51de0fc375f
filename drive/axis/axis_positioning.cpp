// The turns of the blocks of positioning, in the slices of 1 ms.
#include <algorithm>
#include <cmath>
#include <utility>

#include "drive/axis/axis.hpp"

namespace drive {
namespace {

constexpr std::int32_t kSpeedControlWithEncoder = 21;   // p1300
constexpr std::uint32_t kOverflowOfActualPosition = 1;  // value of F07493

/// Whether @p number is a fault of the motor encoder.
constexpr bool is_of_encoder(std::uint16_t number) noexcept {
  constexpr std::uint16_t kNotReady = 7575;
  constexpr std::uint16_t kFirst = 31100;
  constexpr std::uint16_t kLast = 31999;
  return number == kNotReady || (number >= kFirst && number <= kLast);
}

}  // namespace

void Axis::lose_position() noexcept {
  block<ActualPosition>().power_on(train_.signals().encoder_counts);
  block<Positioner>().lose_reference();
}

bool Axis::has_encoder_fault() const noexcept {
  return std::ranges::any_of(messages().faults(),
                             [](const FaultEntry& fault) { return is_of_encoder(fault.row->number); });
}

void Axis::read_position() noexcept {
  const auto& positioner = block<Positioner>();
  const bool tracks = positioner.tracks();
  const bool asks = positioner.blocks().awaits_probe(positioner.settings);
  auto& actual = block<ActualPosition>();
  // The coordinate that was written with p2507 is known when the positioner has taken it, a slice later.
  const bool asked =
      std::exchange(adjustment_asked_, actual.settings.adjustment == ActualPosition::kStartAdjustment);
  actual.run({.counts = train_.signals().encoder_counts,
              .speed = train_.signals().measured_speed,
              .encoder_faulty = has_encoder_fault(),
              .inputs = edges_,
              .reference_coordinate = positioner.inputs.reference_coordinate[0],
              .is_referenced = positioner.is_referenced(),
              .holds_mark = positioner.searches() && !positioner.awaits_mark(),
              .holds_probe = positioner.is_flying() && !positioner.awaits_probe(),
              .holds_adjustment = !asked,
              .asks_probe = asks,
              .modulo_range = std::llround(positioner.modulo_range()),
              .setpoint = tracks ? std::nullopt : std::optional{positioner.position()}});
  show_position_messages();
  block_asked_for_probe_ = asks;
}

/// What the actual position has found, in the words of the positioner.
void Axis::show_position_messages() noexcept {
  using enum PositioningMessage;
  const auto& actual = block<ActualPosition>();
  auto& positioner = block<Positioner>();
  PositioningMessages& messages = positioner.messages();
  if (actual.reference_lost()) positioner.lose_reference();
  messages.show(SaveAdjustment, actual.adjustment_unsaved());
  messages.show(NoEncoder, actual.has_no_encoder());
  messages.show(ReferenceInterrupted,
                actual.interrupted() && !block_asked_for_probe_ && !positioner.search_has_failed());
  messages.show(SettingValueActive, actual.is_held());
  messages.show(ProbeNotPossible, actual.probe_impossible(), static_cast<std::uint32_t>(actual.probe_refusal()));
  messages.show(Encoder1ProbeNotPossible, actual.encoder_1_probe_impossible(),
                static_cast<std::uint32_t>(actual.encoder_1_probe_refusal()));
  messages.show(Encoder1Fault, actual.encoder_1_faulty());
  messages.show(Encoder1SettingValueActive, actual.encoder_1_held());
  messages.show(Encoder1Missing, actual.encoder_1_missing());
  messages.show(Encoder1Overflow, actual.encoder_1_overflows(), kOverflowOfActualPosition);
  messages.show(Encoder1Interrupted, actual.encoder_1_interrupted());
  messages.fault_once(ModuloDoesNotFit, actual.multiturn_mismatch());
  messages.fault_once(EncoderFault, actual.encoder_faulty());
  messages.fault_once(PositionOverflow, actual.overflows(), kOverflowOfActualPosition);
  messages.fault_once(ReferenceOutOfRange, actual.adjustment_refused(),
                      static_cast<std::uint32_t>(actual.largest_coordinate()));
}

void Axis::lead_position() noexcept {
  auto& positioner = block<Positioner>();
  auto& actual = block<ActualPosition>();
  auto& control = block<PositionControl>();
  const auto& channel = block<SetpointChannel>();
  positioner.run({.highest_speed = std::min(std::abs(channel.forward_limit()), std::abs(channel.backward_limit())),
                  .positioning_window = control.settings.positioning_window,
                  .monitoring_time = control.settings.positioning_time,
                  .has_fault = !messages().faults().empty(),
                  .has_encoder_control = block<SpeedControl>().settings.control_mode == kSpeedControlWithEncoder,
                  .is_ready_to_switch_on = !block<SequenceControl>().pulses_enabled()});
  control.shift(positioner.moved_setpoint_by());
  if (positioner.sets_actual()) {
    static_cast<void>(actual.set_position(std::llround(positioner.position())));
    control.place(positioner.position());
  } else if (const double by = positioner.moves_actual_by(); std::abs(by) > 0.0) {
    actual.correct(std::llround(by));
  }
  if (positioner.modulo_range() > 0.0 && !positioner.tracks()) actual.wrap(positioner.position());
}

bool Axis::is_position_control_possible() const noexcept {
  const auto& control = block<SpeedControl>();
  return block<ActualPosition>().position_valid() && block<SequenceControl>().operates() &&
         control.settings.control_mode == kSpeedControlWithEncoder && !control.torque_control() && !jogs() &&
         !block<OperatorPanel>().is_active() && !block<Identification>().leads() && !brake_opens();
}

void Axis::control_position() noexcept {
  using enum PositioningMessage;
  const auto& sequence = block<SequenceControl>();
  const auto& positioner = block<Positioner>();
  auto& control = block<PositionControl>();
  const bool reacts = sequence.state() == State::FaultReactionActive || sequence.effective().has_off2() ||
                      sequence.effective().has_off3();
  control.run({.is_possible = is_position_control_possible(),
               .requests_tracking = reacts,
               .modulo_range = positioner.modulo_range(),
               .stop_deviation = positioner.settings.fixed_stop_following_error,
               .stop_window = positioner.settings.fixed_stop_window});
  PositioningMessages& messages = block<Positioner>().messages();
  if (control.found().standstill) messages.raise(StandstillMonitoring);
  if (control.found().position) messages.raise(PositionMonitoring);
  if (control.found().following_error) messages.raise(FollowingError);
}

void Axis::follow_position() noexcept {
  if (!block<PositionControl>().is_enabled() || !command_.pulses_enabled) return;
  block<SetpointChannel>().follow_position(block<SpeedSetpoint2>().inputs.speed);
  const auto& positioner = block<Positioner>();
  command_.limits = block<TorqueSetpoint>().limits();
  if (!positioner.limits_torque()) return;
  const double torque = positioner.torque_limit();
  command_.limits = {std::min(command_.limits.upper, torque), std::max(command_.limits.lower, -torque)};
}

void Axis::tell_positioning() noexcept {
  PositioningMessages& positioning = block<Positioner>().messages();
  block<ActualPosition>().begin_cycle();
  if (!positioning.has_news()) return;
  positioning.tell([this](const PositioningMessageRow& row, bool present, std::uint32_t value) {
    const FaultRow* const message = find_fault(row.number);
    if (message == nullptr) return;
    if (!present)
      memory().withdraw(*message);
    else
      enter(*message, value, row.comes == Comes::Once ? Cause::Gone : Cause::Present);
  });
  on_messages_changed();
}

}  // namespace drive
