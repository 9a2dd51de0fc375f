#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/control/field/current_controller.hpp"
#include "motor/control/field/fed_start.hpp"
#include "motor/control/field/induction_field.hpp"
#include "motor/control/field/synchronous_field.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/control/speed_loop.hpp"

namespace motor {

/// Field-oriented control of one machine, with or without encoder: from the command to the voltage of the next
/// period. @p Field knows the machine.
template <class Field>
class FieldControl {
 public:
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
  SpaceVector step(const Measurement& measured, const DriveCommand& command, Signals& signals) noexcept {
    if (++ticks_ == kSlowTicks) trim(measured.dc_voltage, signals);
    if (!with_encoder_) return without_encoder(measured, command, signals);
    const Frame frame = field_.frame(measured);
    const SpaceVector current = product(conjugate(frame.direction), measured.current);
    const SpaceVector voltage = lead({measured, frame, current}, measured.speed, command, signals);
    field_.advance(current);
    return voltage;
  }

 private:
  /// What a period starts from.
  struct Situation {
    const Measurement& measured;
    Frame frame;
    SpaceVector current;  // in that frame
  };

  SpaceVector lead(const Situation& now, double speed, const DriveCommand& command, Signals& signals) noexcept {
    const double torque = torque_for(now, speed, command, signals);
    SpaceVector setpoint = field_.currents(torque, now.frame.frequency);
    setpoint.re += surplus_;
    const FluxEffect effect = field_.effect(now.current, now.frame);
    signals.torque = effect.torque;
    return give(now, setpoint, effect.voltage, signals);
  }
  double torque_for(const Situation& now, double speed, const DriveCommand& command, Signals& signals) noexcept {
    if (field_.magnetised()) [[likely]]
      return loop_.step(command, speed, field_.reachable(), now.measured.dc_voltage, signals);
    loop_.reset(speed);
    signals.torque_setpoint = 0.0;
    signals.torque_limit_reached = false;
    signals.torque_limits = {};
    return 0.0;
  }
  /// Voltage that leads to @p setpoint, turned to where the frame will be when it acts.
  SpaceVector give(const Situation& now, SpaceVector setpoint, SpaceVector forward, Signals& signals) noexcept {
    const double highest = VoltageReserve::highest(now.measured.dc_voltage);
    const SpaceVector voltage = controller_.step(setpoint, now.current, forward, highest);
    frequency_ = now.frame.frequency;
    signals.d_current = now.current.re;
    signals.q_current = now.current.im;
    signals.d_current_setpoint = setpoint.re;
    signals.q_current_setpoint = setpoint.im;
    signals.frequency = frequency_;
    signals.voltage_limited = controller_.limited();
    return product(product(bounded_rotation(kLead * frequency_), now.frame.direction), voltage);
  }
  /// What need not be done in every period.
  void trim(double dc_voltage, Signals& signals) noexcept {
    ticks_ = 0;
    loop_.follow();
    field_.trim(kSlowTicks * kControlPeriod, controller_.demand(), VoltageReserve::highest(dc_voltage),
                frequency_);
    signals.magnetised = field_.magnetised();
    signals.flux = field_.flux();
  }

  SpaceVector without_encoder(const Measurement& measured, const DriveCommand& command, Signals& signals) noexcept;
  SpaceVector feed(const Measurement& measured, const Frame& seen, const DriveCommand& command,
                   Signals& signals) noexcept;
  void begin_feeding(const Measurement& measured, const Frame& seen) noexcept;
  void end_feeding(const Measurement& measured, const Frame& seen) noexcept;

  static constexpr int kSlowTicks = 8;                   // periods
  static constexpr double kLead = 1.5 * kControlPeriod;  // s, from the measurement to the middle of the voltage

  SpeedLoop loop_;
  CurrentController controller_;
  Field field_;
  FedStart fed_;
  double changeover_ = 0.0;  // electrical rad/s
  double pole_pairs_ = 1.0;
  double surplus_ = 0.0;  // current along the flux left over from feeding (A)
  double frequency_ = 0.0;
  int ticks_ = 0;
  bool with_encoder_ = true;
  bool feeding_ = false;
};

extern template class FieldControl<SynchronousField>;
extern template class FieldControl<InductionField>;

}  // namespace motor
