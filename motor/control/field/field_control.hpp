#pragma once

#include <tuple>

#include "motor/control/control_settings.hpp"
#include "motor/control/field/current_controller.hpp"
#include "motor/control/field/fed_start.hpp"
#include "motor/control/field/voltage_reserve.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/control/speed_loop.hpp"
#include "motor/data/machine_data.hpp"

namespace motor {

/// Field-oriented control of one machine, with or without encoder: from the command to the voltage of the next
/// period. @p Field knows the machine.
template <class Field>
class FieldControl {
 public:
  using Number = typename Field::Number;

  /// Takes over data and settings; @p delay (s) is how late torque and measured speed come. What is running goes
  /// on.
  void configure(const MachineData& machine, const ControlSettings& settings, double delay) noexcept;
  /// Share of the rated flux to keep from now on (p1570), positive; for machines whose flux is built up.
  void set_flux_share(double share) noexcept { field_.set_flux_share(share); }
  /// Pulses come: empty controllers, at @p speed of the encoder (rad/s).
  void start(double speed) noexcept;
  /// One period with the pulses off at @p speed of the encoder (rad/s).
  void coast(double speed) noexcept { field_.coast(speed); }
  /// Voltage for the period after this one, stator frame (V); fills what the control knows into @p signals.
  SpaceVectorOf<Number> step(const MeasurementOf<Number>& measured, const DriveCommandOf<Number>& command,
                             SignalsOf<Number>& signals) noexcept {
    return all(with_encoder_.holds()) ? with_encoder(measured, command, signals)
                                      : without_encoder(measured, command, signals);
  }
  /// The same in the control mode that has an encoder.
  SpaceVectorOf<Number> with_encoder(const MeasurementOf<Number>& measured, const DriveCommandOf<Number>& command,
                                     SignalsOf<Number>& signals) noexcept {
    count(measured, signals);
    const FrameOf<Number> frame = field_.frame(measured);
    const SpaceVectorOf<Number> current = product(conjugate(frame.direction), measured.current);
    const Situation now{measured.dc_voltage, frame, current};
    const SpaceVectorOf<Number> voltage = give(now, lead(now, measured.speed, command, signals), signals);
    field_.advance(current);
    return voltage;
  }
  /// And in that which has none.
  SpaceVectorOf<Number> without_encoder(const MeasurementOf<Number>& measured,
                                        const DriveCommandOf<Number>& command,
                                        SignalsOf<Number>& signals) noexcept;

  const Field& field() const noexcept { return field_; }
  Field& field() noexcept { return field_; }

 private:
  /// What a period starts from.
  struct Situation {
    Number dc_voltage;  // V
    FrameOf<Number> frame;
    SpaceVectorOf<Number> current;  // in that frame
  };
  /// What the current controllers are to bring about, and the voltage that is known to be needed.
  struct Aim {
    SpaceVectorOf<Number> setpoint;  // A
    SpaceVectorOf<Number> forward;   // V
  };

  [[gnu::always_inline]] Aim lead(const Situation& now, const Number& speed, const DriveCommandOf<Number>& command,
                                  SignalsOf<Number>& signals) noexcept {
    const Number torque = torque_for(now, speed, command, signals);
    SpaceVectorOf<Number> setpoint = field_.currents(torque, now.frame.frequency);
    setpoint.re += surplus_;
    const FluxEffectOf<Number> effect = field_.effect(now.current, now.frame);
    signals.torque = effect.torque;
    return {setpoint, effect.voltage};
  }
  Number torque_for(const Situation& now, const Number& speed, const DriveCommandOf<Number>& command,
                    SignalsOf<Number>& signals) noexcept {
    const Condition<Number> ready = field_.magnetised();
    if (all(ready)) [[likely]]
      return loop_.step(command, speed, field_.reachable(), now.dc_voltage, signals);
    SpeedLoop<Number> stepped = loop_;
    SignalsOf<Number> seen = signals;
    static_cast<void>(stepped.step(command, speed, field_.reachable(), now.dc_voltage, seen));
    loop_.reset(speed);
    keep<Number>(!ready, loop_, stepped);
    take_torque(ready, seen, signals);
    return signals.torque_setpoint;
  }
  /// Of the torque in @p signals, what @p seen says where @p condition holds, and nothing elsewhere.
  static void take_torque(const Condition<Number>& condition, const SignalsOf<Number>& seen,
                          SignalsOf<Number>& signals) noexcept {
    signals.torque_setpoint = select<Number>(condition, seen.torque_setpoint, 0.0);
    signals.torque_limit_reached = condition && seen.torque_limit_reached;
    signals.torque_limits = {select<Number>(condition, seen.torque_limits.upper, 0.0),
                             select<Number>(condition, seen.torque_limits.lower, 0.0)};
  }
  /// Voltage that leads to @p aim, turned to where the frame will be when it acts.
  SpaceVectorOf<Number> give(const Situation& now, const Aim& aim, SignalsOf<Number>& signals) noexcept {
    const Number highest = VoltageReserve<Number>::highest(now.dc_voltage);
    const SpaceVectorOf<Number> voltage = controller_.step(aim.setpoint, now.current, aim.forward, highest);
    frequency_ = now.frame.frequency;
    signals.d_current = now.current.re;
    signals.q_current = now.current.im;
    signals.d_current_setpoint = aim.setpoint.re;
    signals.q_current_setpoint = aim.setpoint.im;
    signals.frequency = frequency_;
    signals.voltage_limited = controller_.limited();
    return product(product(bounded_rotation<Number>(kLead * frequency_), now.frame.direction), voltage);
  }
  void count(const MeasurementOf<Number>& measured, SignalsOf<Number>& signals) noexcept {
    ticks_ += 1.0;
    if (const Condition<Number> due = ticks_ == kSlowTicks; any(due)) trim(due, measured.dc_voltage, signals);
  }
  /// What need not be done in every period, where it is @p due.
  void trim(const Condition<Number>& due, const Number& dc_voltage, SignalsOf<Number>& signals) noexcept {
    ticks_ = select<Number>(due, 0.0, ticks_);
    loop_.follow(due);
    const Number highest = VoltageReserve<Number>::highest(dc_voltage);
    if (all(due)) [[likely]] {
      field_.trim(kSlowTicks * kControlPeriod, controller_.demand(), highest, frequency_);
    } else {
      const Field before = field_;
      field_.trim(kSlowTicks * kControlPeriod, controller_.demand(), highest, frequency_);
      keep<Number>(due, field_, before);
    }
    signals.magnetised = select_condition(due, Condition<Number>{field_.magnetised()}, signals.magnetised);
    signals.flux = select<Number>(due, field_.flux(), signals.flux);
  }

  Situation fed_situation(const MeasurementOf<Number>& measured) const noexcept;
  Aim feed(const MeasurementOf<Number>& measured, const FrameOf<Number>& seen,
           const DriveCommandOf<Number>& command, SignalsOf<Number>& signals) noexcept;
  SpaceVectorOf<Number> lead_or_feed(const Condition<Number>& feeds, const Situation& now,
                                     const MeasurementOf<Number>& measured, const DriveCommandOf<Number>& command,
                                     SignalsOf<Number>& signals) noexcept;
  void turn_fed(const MeasurementOf<Number>& measured, const FrameOf<Number>& seen,
                const DriveCommandOf<Number>& command) noexcept;
  void begin_feeding(const Condition<Number>& begins, const MeasurementOf<Number>& measured,
                     const FrameOf<Number>& seen) noexcept;
  void end_feeding(const Condition<Number>& ends, const MeasurementOf<Number>& measured,
                   const FrameOf<Number>& seen) noexcept;

  static constexpr double kSlowTicks = 8.0;              // periods
  static constexpr double kLead = 1.5 * kControlPeriod;  // s, from the measurement to the middle of the voltage

  CurrentController<Number> controller_;
  SpeedLoop<Number> loop_;
  FedStart<Number> fed_;
  Number changeover_ = 0.0;  // electrical rad/s
  Number surplus_ = 0.0;     // current along the flux left over from feeding (A)
  Number frequency_ = 0.0;
  Number ticks_ = 0.0;
  Flag<Number> with_encoder_{Condition<Number>{true}};
  Flag<Number> feeding_{};
  Field field_;
};

}  // namespace motor
