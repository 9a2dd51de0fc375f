#pragma once

#include <numbers>

#include "motor/control/control_settings.hpp"
#include "motor/control/field/field_control.hpp"
#include "motor/control/field/induction_circuit.hpp"
#include "motor/control/field/voltage_reserve.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// An induction machine as its field-oriented control sees it. With an encoder the rotor flux follows from
/// currents and speed, without one from voltages and currents. Currents and voltages are those of the flux frame.
template <class Type>
class InductionField {
 public:
  using Number = Type;
  using Vector = SpaceVectorOf<Number>;

  void configure(const MachineData& machine, const ControlSettings& settings) noexcept;
  /// Share of the rated flux to keep from now on (p1570), positive.
  void set_flux_share(double share) noexcept;
  /// Pulses come: what is left of the flux is taken over with an encoder, and lost without.
  void start() noexcept;
  /// One period with the pulses off: the flux decays, and turns with the rotor at @p speed (rad/s).
  void coast(double speed) noexcept {
    if (flux_ <= 0.0) return;
    flux_ = flux_ > kGone * rated_flux_ ? flux_ * (1.0 - kControlPeriod * decay_) : 0.0;
    frame_.direction = turned(frame_.direction, kControlPeriod * pole_pairs_ * speed);
  }

  /// Frame of the rotor flux by the current model.
  FrameOf<Number> frame(const MeasurementOf<Number>& measured) noexcept {
    const Vector current = measured.current * conjugate(frame_.direction);
    frame_.frequency = pole_pairs_ * measured.speed + slip(current.im);
    return frame_;
  }
  /// Goes on to the next period with @p current in the present frame.
  void advance(const Vector& current) noexcept {
    flux_ += kControlPeriod * (circuit_.rotor_resistance * current.re - decay_ * flux_);
    frame_.direction = turned<Number>(frame_.direction, kControlPeriod * frame_.frequency);
  }
  /// Frame of the rotor flux as voltages and currents show it.
  FrameOf<Number> observe(const MeasurementOf<Number>& measured) noexcept;
  /// Starts to observe on @p frame.
  void start_observer(const FrameOf<Number>& frame, const Vector& current) noexcept {
    frame_ = frame;
    current_ = current;
    electrical_speed_ = frame.frequency;
  }
  /// Speed of the shaft in the frame last observed (rad/s).
  Number speed(const FrameOf<Number>& /*frame*/) const noexcept { return electrical_speed_ / pole_pairs_; }
  /// Torque (N·m) that a fed current of @p amplitude (A) can give.
  double pull(double amplitude) const noexcept {
    return 0.5 * torque_factor_ * standing_flux(circuit_, amplitude) * amplitude;
  }
  /// The flux follows a fed current by itself.
  static Number lag(const Number& /*torque*/, const Number& /*amplitude*/) noexcept { return 0.0; }
  static Number damping(const FrameOf<Number>& /*frame*/) noexcept { return 0.0; }

  /// Currents for @p torque (N·m) and the flux that voltage and speed allow.
  Vector currents(const Number& torque, const Number& frequency) noexcept;
  /// Voltage that rotation takes with @p current in @p frame, and the torque that it makes.
  FluxEffectOf<Number> effect(const Vector& current, const FrameOf<Number>& frame) const noexcept {
    const Number across = frame.frequency * circuit_.leakage;
    const Number turning = frame.frequency - slip(current.im);
    return {{-across * current.im - decay_ * flux_, across * current.re + turning * flux_}, torque(current)};
  }
  /// Voltage controller, saturation and torque limit, every @p dt (s), as for SynchronousField.
  void trim(double dt, const Number& demand, const Number& highest, const Number& frequency) noexcept;
  Number reachable() const noexcept { return reachable_; }
  Number torque(const Vector& current) const noexcept { return torque_factor_ * flux_ * current.im; }
  /// Whether the flux has been built up since the pulses came.
  Condition<Number> magnetised() const noexcept { return magnetised_.holds(); }
  Number flux() const noexcept { return flux_; }
  Number pole_pairs() const noexcept { return pole_pairs_; }

 private:
  Number usable_flux() const noexcept { return maximum<Number>(flux_, kLeastFlux * rated_flux_); }
  Number slip(const Number& current) const noexcept { return circuit_.rotor_resistance * current / usable_flux(); }

  static constexpr double kLeastFlux = 0.1;        // of the rated one
  static constexpr double kGone = 1e-3;            // of the rated one
  static constexpr double kFluxRate = 40.0;        // 1/s, of the flux controller
  static constexpr double kFluxShare = 0.8;        // of the current limit that may build up flux
  static constexpr double kMagnetised = 0.95;      // of the rated flux
  static constexpr double kSpeedRate = 300.0;      // 1/s, of the speed estimate
  static constexpr double kObserverDamping = 0.2;  // of the observer at speed

  InductionCircuitOf<Number> circuit_;
  VoltageReserve<Number> reserve_;
  Number pole_pairs_ = 1.0;
  Number torque_factor_ = 1.5;  // 1.5 pole pairs
  Number current_limit_ = 1.0;  // A
  Number full_flux_ = 1.0;      // rated one (V·s)
  Number flux_share_ = 1.0;
  Number rated_flux_ = 1.0;  // what is kept below field weakening (V·s)
  Number decay_ = 1.0;       // R_R/L_M at the present flux (1/s)
  Number inductance_ = 1.0;  // L_M at the present flux (H)
  FrameOf<Number> frame_{};
  Number flux_ = 0.0;       // V·s
  Number goal_ = 0.0;       // flux setpoint (V·s)
  Number reachable_ = 0.0;  // N·m
  Number electrical_speed_ = 0.0;
  Vector current_{};  // of the last period, stator frame
  Vector setpoint_{};
  Flag<Number> weakening_{};
  Flag<Number> magnetised_{};
  Flag<Number> with_encoder_{Condition<Number>{true}};
};

/// Voltage model whose flux along the frame is drawn to that of the current model. The gain turns the correction
/// ever more across the flux as the speed rises, which damps the observer without knowing the speed well.
template <class Type>
auto InductionField<Type>::observe(const MeasurementOf<Number>& measured) noexcept -> FrameOf<Number> {
  const Vector mean = 0.5 * (measured.current + current_);
  const Vector change = (circuit_.leakage / kControlPeriod) * (measured.current - current_);
  current_ = measured.current;
  const Vector middle = frame_.direction * bounded_rotation<Number>(0.5 * kControlPeriod * frame_.frequency);
  const Vector back = conjugate(middle);
  const Vector induced = (measured.voltage - circuit_.stator_resistance * mean - change) * back;
  const Vector current = mean * back;
  const Number residual = circuit_.rotor_resistance * current.re - decay_ * flux_ - induced.re;
  const Number speed = electrical_speed_;
  const Number gain = (decay_ + 2.0 * kObserverDamping * abs(speed)) / (decay_ * decay_ + speed * speed);
  const Vector corrected = induced + (gain * residual) * Vector{decay_, speed};
  flux_ = maximum<Number>(0.0, flux_ + kControlPeriod * corrected.re);
  frame_.frequency = corrected.im / usable_flux();
  frame_.direction = turned<Number>(frame_.direction, kControlPeriod * frame_.frequency);
  electrical_speed_ += kSpeedRate * kControlPeriod * (frame_.frequency - slip(current.im) - electrical_speed_);
  return frame_;
}

template <class Type>
auto InductionField<Type>::currents(const Number& torque, const Number& frequency) noexcept -> Vector {
  const Number across = circuit_.leakage * setpoint_.im;
  const Number room = reserve_.room();
  const Number needed = rated_flux_ * (1.0 + circuit_.leakage / inductance_);
  const Condition<Number> weakening = (needed * needed + across * across) * frequency * frequency > room * room;
  weakening_ = weakening;
  goal_ = rated_flux_;
  if (any(weakening)) {
    const Number limit = room / frequency;
    const Number along = sqrt(maximum<Number>(0.0, limit * limit - across * across));
    goal_ = select<Number>(weakening, bounded<Number>(along / needed, kLeastFlux, 1.0) * rated_flux_, goal_);
  }
  const Number forcing = kFluxRate * (goal_ - flux_) / circuit_.rotor_resistance;
  const Number most = kFluxShare * current_limit_;
  const Number d = bounded<Number>(goal_ / inductance_ + forcing, -most, most);
  const Number q_limit = sqrt(current_limit_ * current_limit_ - d * d);
  setpoint_ = {d, bounded<Number>(torque / (torque_factor_ * usable_flux()), -q_limit, q_limit)};
  return setpoint_;
}

template <class Type>
void InductionField<Type>::trim(double dt, const Number& demand, const Number& highest,
                                const Number& frequency) noexcept {
  const Number drop =
      circuit_.stator_resistance * maximum<Number>(0.0, copysign(Number{1.0}, frequency) * setpoint_.im);
  reserve_.follow(dt, demand, highest, drop, weakening_.holds());
  inductance_ = magnetising_inductance(circuit_, flux_);
  decay_ = circuit_.rotor_resistance / inductance_;
  const Condition<Number> magnetised = magnetised_.holds() || flux_ > kMagnetised * goal_;
  magnetised_ = magnetised;
  const Number d = minimum<Number>(abs(goal_) / inductance_, kFluxShare * current_limit_);
  const Number by_current = sqrt(current_limit_ * current_limit_ - d * d);
  // Breakdown: beyond it more current across takes more flux than it gives torque.
  const Number fastest = maximum<Number>(abs(frequency), 1e-3);
  const Number by_voltage = reserve_.room() / (fastest * circuit_.leakage * std::numbers::sqrt2);
  reachable_ = select<Number>(magnetised, torque_factor_ * flux_ * minimum<Number>(by_current, by_voltage), 0.0);
}

template <>
void InductionField<double>::configure(const MachineData& machine, const ControlSettings& settings) noexcept;
template <>
void InductionField<double>::set_flux_share(double share) noexcept;
template <>
void InductionField<double>::start() noexcept;

extern template class FieldControl<InductionField<double>>;

}  // namespace motor
