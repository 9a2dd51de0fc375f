// A cycle of an axis: from what its drive has done to what that is to do.
#include <algorithm>
#include <cmath>

#include "cia402/axis/axis.hpp"
#include "cia402/axis/mode_settings.hpp"
#include "cia402/quantities/position_range.hpp"

namespace cia402 {
namespace {

constexpr std::int16_t kSoftwareZeroSource = 6;  // 60D0h
constexpr std::uint32_t kBrakeOutput = 1;        // 60FEh

/// From this share of the speed cap on torque control gives way to speed control.
constexpr double kNearCap = 0.9;

}  // namespace

DriveCommand Axis::lead(const DriveState& drive, std::uint64_t begin) noexcept {
  take(drive, begin);
  if (state() == State::FaultReactionActive && !drive.has_pulses) carry_out(state_.fault_reaction_over());
  if (!drive.has_voltage && state() != State::OperationEnabled) carry_out(state_.voltage_lost());
  demand_ = next_demand();
  watch();
  const DriveCommand command = command_of(demand_);
  show_status();
  return command;
}

/// What the last cycle has brought: place, inputs, probes, home.
void Axis::take(const DriveState& drive, std::uint64_t begin) noexcept {
  std::optional<ZeroPlace> zero;
  if (values_.probe_1_source.get() == kSoftwareZeroSource || values_.probe_2_source.get() == kSoftwareZeroSource) {
    const auto range = range_in_force(values_.position_range_minimum.get(), values_.position_range_maximum.get());
    const double first = place_.increments_at(0.0, scaling_);
    const double period = range ? std::abs(place_.increments_at(modulus_of(*range), scaling_) - first) : 0.0;
    zero = ZeroPlace{.position = first, .period = period};
  }
  inputs_.pass({.motor_from = drive_.increments,
                .motor_to = drive.increments,
                .load_from = drive_.load_place,
                .load_to = drive.load_place,
                .fraction_from = drive_.fraction,
                .fraction_to = drive.fraction},
               zero);
  drive_ = drive;
  const double increments = static_cast<double>(drive.increments) + drive.fraction;
  actual_ = {.position = place_.at(increments, scaling_),
             .velocity = scaling_.velocity_of(drive.speed),
             .torque = drive.torque};
  probes_.pass(inputs_.events(), begin, [this](double at) { return shown(place_.at(at, scaling_)); });
}

/// A mode that is not led by anything else gives it; while the drive cannot follow yet, it waits.
Demand Axis::next_demand() noexcept {
  if (!state_.is_powered()) return {.motion = {.position = actual_.position}};
  if (!drive_.follows && stop_ == Stop::None) return demand_;
  if (stop_ != Stop::None) {
    const Demand demand = braking_.cycle(actual_);
    if (stop_ == Stop::Command && braking_.stands() && state_.is_braking()) {
      const Outcome outcome = state_.standstill_reached();
      carry_out(outcome);
      if (outcome.action == Action::PulsesOff) power_ = Power::Stop;
    }
    if (stop_ == Stop::LimitSwitch && braking_.stands()) {
      stop_ = Stop::None;
      modes_.enter(demand.motion, context());
    }
    return demand;
  }
  const Motion before = present();
  demand_ = modes_.cycle(context());
  take_home();
  at_limit_switch_ = leads_to_limit_switch(demand_);
  return at_limit_switch_ ? demand_before_limit_switch(before) : demand_;
}

/// Zero moves to where the homing has found it, and everything that is a position with it.
void Axis::take_home() noexcept {
  const std::optional<Home> home = modes_.homing().take_home();
  if (!home) return;
  const double before = actual_.position;
  place_.set(home->position, -home->offset);
  const double increments = static_cast<double>(drive_.increments) + drive_.fraction;
  actual_.position = place_.at(increments, scaling_);
  const double by = actual_.position - before;
  modes_.homing().shift(scaling_.sign() * by);
  control_.shift(by);
  demand_.motion.position += by;
}

/// Outside homing a limit switch lets nothing go on towards it; away from it everything is allowed.
bool Axis::leads_to_limit_switch(const Demand& demand) const noexcept {
  if (modes_.active() == Mode::Homing) return false;
  const double velocity = scaling_.sign() * demand.motion.velocity;
  const double direction = demand.lead == Lead::Torque ? demand.motion.torque : velocity;
  return (direction < 0.0 && inputs_.levels().at(Signal::NegativeLimit)) ||
         (direction > 0.0 && inputs_.levels().at(Signal::PositiveLimit));
}

/// What moves brakes with 6085h, what stands stays where it is; set-points before that do not count any more.
Demand Axis::demand_before_limit_switch(const Motion& before) noexcept {
  demand_ = {.motion = before};
  if (std::abs(before.velocity) > 0.0) {
    brake(Braking::QuickStopRamp, Stop::LimitSwitch);
    return braking_.cycle(actual_);
  }
  modes_.enter(before, context());
  return demand_;
}

void Axis::watch() noexcept {
  if (!state_.is_powered()) {
    is_limited_ = false;
    has_following_error_ = false;
    following_window_.restart();
    return;
  }
  is_limited_ = demand_.is_limited || drive_.at_torque_limit || at_limit_switch_ || stop_ == Stop::LimitSwitch;
  if (state() == State::OperationEnabled && modes_.is_lost()) return fault(error::kSetPointsMissing, true);
  const Mode mode = modes_.active();
  const bool is_watched = mode == Mode::ProfilePosition || mode == Mode::InterpolatedPosition ||
                          mode == Mode::CyclicSynchronousPosition;
  const std::uint32_t window = values_.following_error_window.get();
  const bool is_far = is_watched && demand_.lead == Lead::Position && window != kNoWindow && drive_.follows &&
                      std::abs(demand_.motion.position - actual_.position) > static_cast<double>(window);
  has_following_error_ = is_far;
  if (following_window_.update(is_far, values_.following_error_time_out.get()) &&
      state() == State::OperationEnabled)
    fault(error::kFollowingError, true);
}

DriveCommand Axis::command_of(const Demand& demand) noexcept {
  const Span limits = torque_limits_of(values_, scaling_);
  DriveCommand command{
      .power = state_.is_powered() ? Power::On : power_,
      .holds_brake = (values_.physical_outputs.get() & values_.output_mask.get() & kBrakeOutput) != 0,
      .upper_torque = limits.high,
      .lower_torque = limits.low};
  if (!state_.is_powered() || !drive_.follows) {
    control_.start(actual_.position);
    return command;
  }
  command.torque_offset = demand.torque_offset;
  const double next_position = actual_.position + actual_.velocity * kCycle;  // where position control would begin
  switch (demand.lead) {
    case Lead::Position:
      command.speed = scaling_.motor_speed(control_.run(demand, actual_.position));
      break;
    case Lead::Velocity:
      control_.start(next_position);
      command.speed = scaling_.motor_speed(demand.motion.velocity + demand.velocity_offset);
      break;
    case Lead::Torque:
      control_.start(next_position);
      lead_torque(std::clamp(demand.motion.torque + demand.torque_offset, limits.low, limits.high), command);
      break;
  }
  return command;
}

/// Near the speed cap (607Fh, 6080h) speed control holds it, with the torque as its limit.
void Axis::lead_torque(double torque, DriveCommand& command) noexcept {
  const double cap = std::abs(scaling_.motor_speed(context().limits.velocity));
  command.torque_offset = 0.0;
  command.torque = torque;
  command.torque_control = std::copysign(drive_.speed, torque * drive_.speed) < kNearCap * cap;
  if (command.torque_control) return;
  command.speed = std::copysign(cap, torque);
  (torque < 0.0 ? command.lower_torque : command.upper_torque) = torque;
}

}  // namespace cia402
