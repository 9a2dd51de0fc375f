#include "motor/control/field/field_control.hpp"

#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kFedSlope = 0.3;      // of the acceleration that the fed current can give
constexpr double kBlind = 0.3;         // of the changeover speed, below which nothing is to be seen
constexpr double kBack = 0.8;          // of the changeover speed, where feeding begins again
constexpr double kAgreement = 0.3;     // of the frequency, by which feeding and observer may differ
constexpr double kSurplusTime = 0.05;  // s, in which the surplus fades
constexpr double kDampingShare = 0.3;  // of the fed current that may damp

}  // namespace

template <class Field>
void FieldControl<Field>::configure(const MachineData& machine, const ControlSettings& settings,
                                    double delay) noexcept {
  with_encoder_ = settings.mode == ControlMode::Encoder;
  loop_.configure(settings, with_encoder_ ? settings.speed : settings.sensorless_speed, delay);
  controller_.configure(settings.current, kControlPeriod);
  field_.configure(machine, settings);
  pole_pairs_ = machine.pole_pairs;
  changeover_ = pole_pairs_ * settings.changeover_speed;
  const double amplitude = std::numbers::sqrt2 * settings.start_current;
  fed_.configure(amplitude, kFedSlope * pole_pairs_ * field_.pull(amplitude) / settings.inertia);
}

template <class Field>
void FieldControl<Field>::start(double speed) noexcept {
  loop_.reset(speed);
  controller_.reset();
  field_.start();
  fed_.start({});
  if (!with_encoder_) field_.start_observer({}, {});
  feeding_ = true;
  surplus_ = 0.0;
  frequency_ = 0.0;
  ticks_ = kSlowTicks - 1;
}

template <class Field>
SpaceVector FieldControl<Field>::without_encoder(const Measurement& measured, const DriveCommand& command,
                                                 Signals& signals) noexcept {
  const Frame seen = field_.observe(measured);
  if (feeding_) return feed(measured, seen, command, signals);
  if (std::abs(seen.frequency) < kBack * changeover_) {
    begin_feeding(measured, seen);
    return feed(measured, seen, command, signals);
  }
  surplus_ -= surplus_ * (kControlPeriod / kSurplusTime);
  signals.measured_speed = field_.speed(seen);
  return lead({measured, seen, measured.current * conjugate(seen.direction)}, signals.measured_speed, command,
              signals);
}

template <class Field>
SpaceVector FieldControl<Field>::feed(const Measurement& measured, const Frame& seen, const DriveCommand& command,
                                      Signals& signals) noexcept {
  const double wanted = command.torque_control ? std::copysign(2.0 * changeover_, command.torque_setpoint)
                                               : pole_pairs_ * command.speed_setpoint;
  fed_.step(field_.magnetised() ? wanted : 0.0);
  const Frame& frame = fed_.frame();
  const double frequency = std::abs(frame.frequency);
  const bool blind = frequency < kBlind * changeover_;
  if (blind) field_.start_observer(frame, measured.current);
  const bool agrees = std::abs(seen.frequency - frame.frequency) < kAgreement * frequency;
  if (!blind && frequency > changeover_ && agrees) {
    end_feeding(measured, seen);
    return lead({measured, seen, measured.current * conjugate(seen.direction)}, signals.measured_speed, command,
                signals);
  }
  const double damping = kDampingShare * fed_.amplitude();
  SpaceVector setpoint = fed_.current();
  setpoint.im += std::clamp(field_.damping(frame), -damping, damping);
  const SpaceVector current = measured.current * conjugate(frame.direction);
  signals.measured_speed = frame.frequency / pole_pairs_;
  signals.torque = field_.torque(measured.current * conjugate(seen.direction));
  signals.torque_setpoint = signals.torque;
  signals.torque_limit_reached = false;
  signals.torque_limits = command.limits;
  return give({measured, frame, current}, setpoint, {}, signals);
}

/// The fed current leads the flux so far that it carries the torque of now.
template <class Field>
void FieldControl<Field>::begin_feeding(const Measurement& measured, const Frame& seen) noexcept {
  const SpaceVector current = measured.current * conjugate(seen.direction);
  const double sine = field_.lag(field_.torque(current), fed_.amplitude());
  const SpaceVector lag{std::sqrt(1.0 - sine * sine), sine};
  const Frame frame{seen.direction * lag, seen.frequency};
  controller_.turn(lag, field_.effect(current, seen).voltage);
  fed_.start(frame, current * conjugate(lag));
  feeding_ = true;
}

/// The flux frame takes over with the currents of now; what is too much of them along the flux fades.
template <class Field>
void FieldControl<Field>::end_feeding(const Measurement& measured, const Frame& seen) noexcept {
  const SpaceVector current = measured.current * conjugate(seen.direction);
  const double torque = field_.torque(current);
  const double speed = field_.speed(seen);
  surplus_ = current.re - field_.currents(torque, seen.frequency).re;
  loop_.reset(speed, torque);
  controller_.turn(seen.direction * conjugate(fed_.frame().direction), {});
  controller_.shift(-1.0 * field_.effect(current, seen).voltage);
  feeding_ = false;
}

template class FieldControl<SynchronousField>;
template class FieldControl<InductionField>;

}  // namespace motor
