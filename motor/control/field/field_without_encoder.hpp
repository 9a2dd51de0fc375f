#pragma once

#include "motor/control/field/field_control.hpp"

// FieldControl in the control mode without encoder. Of lanes some may be fed and others led, and each changes from
// one to the other by itself.
namespace motor {
namespace sensorless {

inline constexpr double kBlind = 0.3;         // of the changeover speed, below which nothing is to be seen
inline constexpr double kBack = 0.8;          // of the changeover speed, where feeding begins again
inline constexpr double kAgreement = 0.3;     // of the frequency, by which feeding and observer may differ
inline constexpr double kSurplusTime = 0.05;  // s, in which the surplus fades
inline constexpr double kDampingShare = 0.3;  // of the fed current that may damp

}  // namespace sensorless

template <class Field>
auto FieldControl<Field>::without_encoder(const MeasurementOf<Number>& measured,
                                          const DriveCommandOf<Number>& command,
                                          SignalsOf<Number>& signals) noexcept -> SpaceVectorOf<Number> {
  count(measured, signals);
  const FrameOf<Number> seen = field_.observe(measured);
  const Condition<Number> led = !feeding_.holds();
  const Condition<Number> begins = led && abs(seen.frequency) < sensorless::kBack * changeover_;
  const Condition<Number> goes_on = led && !begins;
  if (any(begins)) begin_feeding(begins, measured, seen);
  surplus_ = select<Number>(goes_on, surplus_ - surplus_ * (kControlPeriod / sensorless::kSurplusTime), surplus_);
  signals.measured_speed = select<Number>(goes_on, field_.speed(seen), signals.measured_speed);
  if (any(feeding_.holds())) turn_fed(measured, seen, command);
  const Condition<Number> feeds = feeding_.holds();
  if (all(feeds)) return give(fed_situation(measured), feed(measured, seen, command, signals), signals);
  const Situation now{measured.dc_voltage, seen, measured.current * conjugate(seen.direction)};
  if (!any(feeds)) return give(now, lead(now, signals.measured_speed, command, signals), signals);
  return lead_or_feed(feeds, now, measured, command, signals);
}

template <class Field>
auto FieldControl<Field>::fed_situation(const MeasurementOf<Number>& measured) const noexcept -> Situation {
  const FrameOf<Number>& frame = fed_.frame();
  return {measured.dc_voltage, frame, measured.current * conjugate(frame.direction)};
}

/// Of the lanes some are fed.
template <class Field>
auto FieldControl<Field>::lead_or_feed(const Condition<Number>& feeds, const Situation& now,
                                       const MeasurementOf<Number>& measured,
                                       const DriveCommandOf<Number>& command, SignalsOf<Number>& signals) noexcept
    -> SpaceVectorOf<Number> {
  const SpeedLoop<Number> loop = loop_;
  const Field unled = field_;
  SignalsOf<Number> fed = signals;
  const Aim leading = lead(now, signals.measured_speed, command, signals);
  keep<Number>(!feeds, loop_, loop);
  keep<Number>(!feeds, field_, unled);
  const Field unfed = field_;
  const Aim feeding = feed(measured, now.frame, command, fed);
  keep<Number>(feeds, field_, unfed);
  signals.measured_speed = select<Number>(feeds, fed.measured_speed, signals.measured_speed);
  signals.torque = select<Number>(feeds, fed.torque, signals.torque);
  signals.torque_setpoint = select<Number>(feeds, fed.torque_setpoint, signals.torque_setpoint);
  signals.torque_limit_reached = !feeds && signals.torque_limit_reached;
  signals.torque_limits = {select<Number>(feeds, fed.torque_limits.upper, signals.torque_limits.upper),
                           select<Number>(feeds, fed.torque_limits.lower, signals.torque_limits.lower)};
  const Situation fed_now = fed_situation(measured);
  const Situation either{now.dc_voltage,
                         {select(feeds, fed_now.frame.direction, now.frame.direction),
                          select<Number>(feeds, fed_now.frame.frequency, now.frame.frequency)},
                         select(feeds, fed_now.current, now.current)};
  return give(either,
              {select(feeds, feeding.setpoint, leading.setpoint), select(feeds, feeding.forward, leading.forward)},
              signals);
}

/// Turns the fed current on, until the observer sees where the machine is.
template <class Field>
void FieldControl<Field>::turn_fed(const MeasurementOf<Number>& measured, const FrameOf<Number>& seen,
                                   const DriveCommandOf<Number>& command) noexcept {
  const Condition<Number> feeds = feeding_.holds();
  const Number wanted =
      select<Number>(command.torque_control, copysign(Number{2.0 * changeover_}, command.torque_setpoint),
                     field_.pole_pairs() * command.speed_setpoint);
  const FedStart<Number> before = fed_;
  fed_.step(select<Number>(field_.magnetised(), wanted, 0.0));
  keep<Number>(feeds, fed_, before);
  const FrameOf<Number>& frame = fed_.frame();
  const Number frequency = abs(frame.frequency);
  const Condition<Number> blind = frequency < sensorless::kBlind * changeover_;
  if (const Condition<Number> starts = feeds && blind; all(starts)) {
    field_.start_observer(frame, measured.current);
  } else if (any(starts)) {
    const Field unstarted = field_;
    field_.start_observer(frame, measured.current);
    keep<Number>(starts, field_, unstarted);
  }
  const Condition<Number> agrees = abs(seen.frequency - frame.frequency) < sensorless::kAgreement * frequency;
  const Condition<Number> ends = feeds && !blind && frequency > changeover_ && agrees;
  if (any(ends)) end_feeding(ends, measured, seen);
}

template <class Field>
auto FieldControl<Field>::feed(const MeasurementOf<Number>& measured, const FrameOf<Number>& seen,
                               const DriveCommandOf<Number>& command, SignalsOf<Number>& signals) noexcept -> Aim {
  const FrameOf<Number>& frame = fed_.frame();
  const Number damping = sensorless::kDampingShare * fed_.amplitude();
  SpaceVectorOf<Number> setpoint = fed_.current();
  setpoint.im += bounded<Number>(field_.damping(frame), -damping, damping);
  signals.measured_speed = frame.frequency / field_.pole_pairs();
  signals.torque = field_.torque(measured.current * conjugate(seen.direction));
  signals.torque_setpoint = signals.torque;
  signals.torque_limit_reached = Condition<Number>{false};
  signals.torque_limits = command.limits;
  return {setpoint, {}};
}

/// The fed current leads the flux so far that it carries the torque of now.
template <class Field>
void FieldControl<Field>::begin_feeding(const Condition<Number>& begins, const MeasurementOf<Number>& measured,
                                        const FrameOf<Number>& seen) noexcept {
  const SpaceVectorOf<Number> current = measured.current * conjugate(seen.direction);
  const Number sine = field_.lag(field_.torque(current), fed_.amplitude());
  const SpaceVectorOf<Number> lag{sqrt(1.0 - sine * sine), sine};
  const CurrentController<Number> controller = controller_;
  const FedStart<Number> fed = fed_;
  controller_.turn(lag, field_.effect(current, seen).voltage);
  fed_.start({seen.direction * lag, seen.frequency}, current * conjugate(lag));
  keep<Number>(begins, controller_, controller);
  keep<Number>(begins, fed_, fed);
  feeding_ = feeding_.holds() || begins;
}

/// The flux frame takes over with the currents of now; what is too much of them along the flux fades.
template <class Field>
void FieldControl<Field>::end_feeding(const Condition<Number>& ends, const MeasurementOf<Number>& measured,
                                      const FrameOf<Number>& seen) noexcept {
  const SpaceVectorOf<Number> current = measured.current * conjugate(seen.direction);
  const Number torque = field_.torque(current);
  const Number speed = field_.speed(seen);
  const auto before = std::tuple{field_, loop_, controller_};
  surplus_ = select<Number>(ends, current.re - field_.currents(torque, seen.frequency).re, surplus_);
  loop_.reset(speed, torque);
  controller_.turn(seen.direction * conjugate(fed_.frame().direction), {});
  controller_.shift(-1.0 * field_.effect(current, seen).voltage);
  keep<Number>(ends, field_, std::get<0>(before));
  keep<Number>(ends, loop_, std::get<1>(before));
  keep<Number>(ends, controller_, std::get<2>(before));
  feeding_ = feeding_.holds() && !ends;
}

}  // namespace motor
