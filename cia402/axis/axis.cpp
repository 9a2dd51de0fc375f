#include "cia402/axis/axis.hpp"

#include <cmath>
#include <utility>

#include "cia402/axis/mode_settings.hpp"

namespace cia402 {
namespace {

constexpr unsigned kFaultReset = 0x0080;

/// The mode of 6060h, if there is one of that number (6502h).
constexpr bool is_mode(std::int8_t code) noexcept {
  constexpr unsigned kModes = 0b111'1101'1111;  // 0 to 4, 6 to 10
  return code >= 0 && code <= 10 && (kModes >> static_cast<unsigned>(code) & 1U) != 0;
}

/// What brings the set-points of the cyclic modes.
constexpr ActingSet set_points_of(Mode mode) noexcept {
  switch (mode) {
    case Mode::InterpolatedPosition:
      return bit_of(Acting::Interpolation);
    case Mode::CyclicSynchronousPosition:
      return bit_of(Acting::Position);
    case Mode::CyclicSynchronousVelocity:
      return bit_of(Acting::Velocity);
    case Mode::CyclicSynchronousTorque:
      return bit_of(Acting::Torque);
    default:
      return 0;
  }
}

}  // namespace

Axis::Axis(std::size_t number, AxisValues& values, const AxisSetup& setup, AxisListener& listener) noexcept
    : number_{number},
      values_{values},
      listener_{listener},
      homing_distance_{setup.homing_distance},
      missed_set_points_{setup.missed_setpoints},
      is_absolute_{setup.drive.machine.encoder.type == motor::EncoderType::Absolute},
      scaling_{values},
      modes_{values},
      inputs_{setup.switches, kIncrements} {}

void Axis::power_on(const DriveState& drive) noexcept {
  drive_ = drive;
  state_ = StateMachine{};
  state_.initialised();
  modes_.leave(HomingExit::Disabled);
  modes_.choose(Mode::None);
  modes_.homing().set_homed(false);
  const double here = static_cast<double>(drive.increments) + drive.fraction;
  place_.set(is_absolute_ ? 0.0 : here, 0.0);
  inputs_.pass({.motor_from = drive.increments,
                .motor_to = drive.increments,
                .load_from = drive.load_place,
                .load_to = drive.load_place,
                .fraction_from = drive.fraction,
                .fraction_to = drive.fraction});
  power_ = Power::Off;
  stop_ = Stop::None;
  word_ = 0;
  is_limited_ = has_following_error_ = false;
  values_.modes_of_operation_display.set(0);
  scale();
  show(drive);
}

void Axis::scale() noexcept {
  scaling_ = Scaling{values_};
  actual_.position = place_.at(static_cast<double>(drive_.increments) + drive_.fraction, scaling_);
  demand_ = {.motion = at_rest()};
  control_.start(actual_.position);
  show_position(drive_);
}

ModeContext Axis::context() const noexcept {
  return {.scaling = scaling_,
          .inputs = inputs_,
          .limits = limits_of(values_, scaling_, modes_.homing().is_homed() || is_absolute_),
          .actual = actual_,
          .homing_distance = homing_distance_,
          .missed_set_points = missed_set_points_,
          .is_supervised = remote_ && (with_sync_ & set_points_of(modes_.active())) != 0,
          .has_following_error = has_following_error_};
}

void Axis::act(ActingSet what, TimeNs instant) noexcept {
  if (contains(what, Acting::Mode)) take_mode();
  if (contains(what, Acting::Controlword)) take_controlword();
  const bool is_led = state() == State::OperationEnabled && stop_ == Stop::None;
  if (is_led) modes_.set_points(what, instant, context());
  if (contains(what, Acting::Probe))
    probes_.set(values_.probe_function.get(), {values_.probe_1_source.get(), values_.probe_2_source.get()},
                std::chrono::duration<double>(instant) / kCycleTime);
  show_status();
  if (contains(what, Acting::Probe)) show_probes();
}

/// 6061h follows at once, in motion too.
void Axis::take_mode() noexcept {
  const std::int8_t code = values_.modes_of_operation.get();
  if (!is_mode(code)) return;
  const Mode mode{code};
  if (mode == modes_.active()) return;
  if (modes_.active() != Mode::None) modes_.leave(HomingExit::OtherMode);
  const Motion from = present();
  modes_.choose(mode);
  values_.modes_of_operation_display.set(code);
  if (state() == State::OperationEnabled && stop_ != Stop::Command) modes_.enter(from, context());
}

void Axis::take_controlword() noexcept {
  if (defect_.ignores_controlword) return;
  const std::uint16_t former = word_;
  word_ = static_cast<std::uint16_t>((values_.controlword.get() & ~unsigned{defect_.controlword_cleared}) |
                                     defect_.controlword_set);
  const bool resets = state() == State::Fault && (word_ & ~former & kFaultReset) != 0;
  const bool can_reset = !resets || listener_.on_fault_reset(number_);
  carry_out(state_.controlword(word_, option_codes_of(values_), can_reset));
  if (state() != State::OperationEnabled) return;
  modes_.controlword(word_, former, context());
  follow_halt();
}

bool Axis::spoil(const device::AxisDefect& defect) noexcept {
  if (std::exchange(defect_, defect) == defect) return false;
  take_controlword();
  show_status();
  return true;
}

void Axis::reset_fault() noexcept {
  if (state() != State::Fault || !listener_.on_fault_reset(number_)) return;
  carry_out(state_.command(Event::FaultReset, option_codes_of(values_)));
  show_status();
}

/// What has to be done besides being in another state. Enabling from Quick stop active goes on with what was
/// there.
void Axis::carry_out(const Outcome& outcome) noexcept {
  switch (outcome.action) {
    case Action::None:
      return;
    case Action::Enable: {
      const bool was_powered = power_ == Power::On;
      const bool goes_on = outcome.transitions[0] == 16;
      if (!was_powered) demand_ = {.motion = at_rest()};
      const Motion from = present();
      power_ = Power::On;
      stop_ = Stop::None;
      return goes_on ? modes_.resume(from, context()) : modes_.enter(from, context());
    }
    case Action::PulsesOff:
      modes_.leave(state() == State::Fault ? HomingExit::Fault : HomingExit::Disabled);
      power_ = Power::Off;
      stop_ = Stop::None;
      return;
    case Action::Brake:
      if (state() == State::FaultReactionActive) modes_.leave(HomingExit::Fault);
      if (state() == State::ReadyToSwitchOn || state() == State::SwitchedOn) modes_.leave(HomingExit::Disabled);
      return brake(outcome.braking, Stop::Command);
  }
}

void Axis::follow_halt() noexcept {
  if (state_.wants_halt() && stop_ != Stop::Halt)
    return brake(stop_of(StopCause::Halt, option_codes_of(values_)).braking, Stop::Halt);
  if (state_.wants_halt() || stop_ != Stop::Halt) return;
  const Motion from = present();
  stop_ = Stop::None;
  modes_.resume(from, context());
}

void Axis::brake(Braking how, Stop stop) noexcept {
  const Motion from = present();
  stop_ = stop;
  switch (how) {
    case Braking::None:
    case Braking::MaxTorque:
      return braking_.stop_hard(from);
    case Braking::SlowDownRamp:
      return braking_.ramp(from, static_cast<double>(values_.profile_deceleration.get()));
    case Braking::QuickStopRamp:
      return braking_.ramp(from, static_cast<double>(values_.quick_stop_deceleration.get()));
  }
}

/// Where the demand is: of a mode that leads velocity or torque, the axis is what knows the rest.
Motion Axis::present() const noexcept {
  Motion motion = demand_.motion;
  if (demand_.lead != Lead::Position) motion.position = actual_.position;
  if (demand_.lead == Lead::Torque) motion.velocity = actual_.velocity;
  if (demand_.lead != Lead::Torque) motion.torque = actual_.torque;
  return motion;
}

/// Where the axis is: nothing leads it.
Motion Axis::at_rest() const noexcept {
  return {.position = actual_.position, .velocity = actual_.velocity, .torque = 0.0};
}

void Axis::set_remote(bool remote, ActingSet with_sync) noexcept {
  remote_ = remote;
  with_sync_ = with_sync;
  show_status();
}

void Axis::lose_connection(bool only_late) noexcept {
  const AbortReaction reaction = abort_reaction(values_.abort_connection_option.get());
  if (only_late && reaction == AbortReaction::DisableVoltage) return;
  switch (reaction) {
    case AbortReaction::None:
      return;
    case AbortReaction::Fault:
      return fault(error::kConnectionAbort, drive_.has_pulses);
    case AbortReaction::DisableVoltage:
      carry_out(state_.command(Event::DisableVoltage, option_codes_of(values_)));
      return show_status();
    case AbortReaction::QuickStop:
      if (state() == State::OperationEnabled)
        carry_out(state_.command(Event::QuickStop, option_codes_of(values_)));
      return show_status();
  }
}

void Axis::fault(ErrorCode error, bool can_brake) noexcept {
  values_.error_code.set(error.code);
  listener_.on_error(number_, error);
  carry_out(state_.fault(option_codes_of(values_), can_brake));
  show_status();
}

}  // namespace cia402
