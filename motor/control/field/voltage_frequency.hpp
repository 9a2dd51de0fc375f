#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/control/field/voltage_reserve.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// V/f control: a voltage whose amplitude follows its frequency, without regard to the rotor. Slip compensation,
/// resonance damping and the I_max controller change the frequency by what the currents show.
template <class Number>
class VoltageFrequencyControl {
 public:
  using Vector = SpaceVectorOf<Number>;

  void configure(const MachineData& machine, const ControlSettings& settings) noexcept;
  /// Pulses come: from frequency 0.
  void start() noexcept;
  /// Voltage for the period after this one, stator frame (V); fills what the control knows into @p signals.
  Vector step(const MeasurementOf<Number>& measured, const DriveCommandOf<Number>& command,
              SignalsOf<Number>& signals) noexcept {
    const Vector current = measured.current * conjugate(frame_.direction);
    watch(measured, current);
    frame_.frequency = frequency_for(command, measured.dc_voltage);
    frame_.direction = turned<Number>(frame_.direction, kControlPeriod * frame_.frequency);
    const Number wanted = amplitude_for(frame_.frequency, command.acceleration_setpoint);
    const Number amplitude = minimum<Number>(wanted, VoltageReserve<Number>::highest(measured.dc_voltage));
    signals.voltage_limited = amplitude < wanted;
    signals.torque_limits = command.limits;
    report(current, signals);
    return amplitude * frame_.direction;
  }

 private:
  /// What the currents show; @p current is along and across the voltage.
  void watch(const MeasurementOf<Number>& measured, const Vector& current) noexcept {
    const Number across_gap =
        1.5 * (dot(measured.voltage, measured.current) - resistance_ * norm(measured.current));
    const Number slowest = kSlowShare * rated_frequency_;
    const Number turning = copysign(maximum<Number>(abs(frame_.frequency), slowest), frame_.frequency);
    torque_ += kControlPeriod / kTorqueTime * (pole_pairs_ * across_gap / turning - torque_);
    active_current_ += kControlPeriod / kSwingTime * (current.re - active_current_);
    swing_ = current.re - active_current_;
    excess_ = length(current) - current_limit_;
    const Number change = reduction_rate_ * kControlPeriod * excess_;
    const Number less =
        copysign(minimum<Number>(abs(reduction_), -reduction_rate_ * kControlPeriod * excess_), reduction_);
    const Number reduction =
        select<Number>(excess_ > 0.0, reduction_ + copysign(change, active_current_), reduction_ - less);
    reduction_ = bounded<Number>(reduction, -rated_frequency_, rated_frequency_);
  }
  Number frequency_for(const DriveCommandOf<Number>& command, const Number& dc_voltage) const noexcept {
    const Number slip = slip_compensation_ * slip_rate_ * torque_;
    const Number largest = kLargestSwing * rated_frequency_;
    const Number damping = bounded<Number>(damping_gain_ * swing_, -largest, largest);
    const Number direction = copysign(Number{1.0}, command.speed_setpoint);
    const Number wanted = pole_pairs_ * abs(command.speed_setpoint) + direction * slip;
    const Number frequency = direction * maximum<Number>(0.0, wanted - reduction_ - damping);
    const Condition<Number> free =
        vdc_max_ <= 0.0 || dc_voltage < vdc_max_ - kVdcBand || abs(frequency) > abs(frame_.frequency);
    if (all(free)) return frequency;
    const Number share = bounded<Number>((vdc_max_ - dc_voltage) / kVdcBand, 0.0, 1.0);
    return select<Number>(free, frequency, frame_.frequency + share * (frequency - frame_.frequency));
  }
  /// Voltage (V peak of a phase) at @p frequency (electrical rad/s).
  Number amplitude_for(const Number& frequency, const Number& acceleration) const noexcept {
    const Number share = minimum<Number>(1.0, abs(frequency) / rated_frequency_);
    const Number ramping = select<Number>(abs(acceleration) > kRamping, acceleration_boost_, 0.0);
    const Number line = select<Number>(parabolic_.holds(), share * share, share) * rated_voltage_ +
                        (1.0 - share) * (boost_ + ramping);
    constexpr double kPhasePeak = 0.81649658092772603;  // sqrt(2/3)
    return maximum<Number>(0.0,
                           kPhasePeak * line - kVirtualResistance * resistance_ * maximum<Number>(0.0, excess_));
  }
  void report(const Vector& current, SignalsOf<Number>& signals) const noexcept {
    signals.measured_speed = (frame_.frequency - slip_rate_ * torque_) / pole_pairs_;
    signals.torque = torque_;
    signals.torque_setpoint = torque_;
    signals.torque_limit_reached = excess_ > 0.0 || abs(reduction_) > 0.0;
    signals.d_current = -current.im;
    signals.q_current = current.re;
    signals.d_current_setpoint = signals.d_current;
    signals.q_current_setpoint = signals.q_current;
    signals.frequency = frame_.frequency;
    signals.magnetised = Condition<Number>{true};
  }

  static constexpr double kTorqueTime = 0.05;    // s, of the torque estimate
  static constexpr double kSwingTime = 0.05;     // s, slower changes of the current are no resonance
  static constexpr double kSlowShare = 0.05;     // of the rated frequency, below it the torque is not to be seen
  static constexpr double kLargestSwing = 0.05;  // of the rated frequency
  static constexpr double kVirtualResistance =
      3.0;                                  // of the stator's: what the I_max controller takes off the voltage
  static constexpr double kVdcBand = 20.0;  // V, over which the frequency is held
  static constexpr double kRamping = 1.0;   // rad/s², from where on the acceleration boost counts

  Number rated_voltage_ = 400.0;  // V rms between lines, as the boosts
  Number boost_ = 0.0;
  Number acceleration_boost_ = 0.0;
  Flag<Number> parabolic_{};
  Number slip_compensation_ = 0.0;
  Number pole_pairs_ = 1.0;
  Number resistance_ = 0.0;
  Number rated_frequency_ = 1.0;  // electrical rad/s
  Number current_limit_ = 1.0;    // A peak
  Number slip_rate_ = 0.0;        // slip a torque (rad/s per N·m)
  Number damping_gain_ = 0.0;     // rad/s per A
  Number reduction_rate_ = 0.0;   // rad/s² per A
  Number vdc_max_ = 0.0;          // V, 0 = never
  FrameOf<Number> frame_{};
  Number torque_ = 0.0;          // estimate (N·m)
  Number active_current_ = 0.0;  // along the voltage, smoothed (A)
  Number swing_ = 0.0;           // what it deviates from that (A)
  Number excess_ = 0.0;          // of the current over its limit (A)
  Number reduction_ = 0.0;  // of the frequency's amount by the I_max controller (rad/s), below 0 when it feeds
};

template <>
void VoltageFrequencyControl<double>::configure(const MachineData& machine,
                                                const ControlSettings& settings) noexcept;
template <>
void VoltageFrequencyControl<double>::start() noexcept;

}  // namespace motor
