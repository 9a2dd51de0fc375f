#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

#include "motor/control/control_settings.hpp"
#include "motor/control/field/field_control.hpp"
#include "motor/control/field/synchronous_observer.hpp"
#include "motor/control/field/synchronous_reference.hpp"
#include "motor/control/field/voltage_reserve.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// A permanent-magnet machine as its field-oriented control sees it: where the flux is, which currents give a
/// torque there, and which voltage they need. Currents and voltages are those of the rotor frame.
template <class Type>
class SynchronousField {
 public:
  using Number = Type;
  using Vector = SpaceVectorOf<Number>;

  void configure(const MachineData& machine, const ControlSettings& settings) noexcept;
  /// Nothing: the flux of magnets is what it is.
  static void set_flux_share(double /*share*/) noexcept {}
  /// Pulses come.
  void start() noexcept;
  /// One period with the pulses off: nothing changes.
  void coast(double /*speed*/) noexcept {}

  /// Frame of the rotor as the encoder sees it.
  FrameOf<Number> frame(const MeasurementOf<Number>& measured) const noexcept {
    return {measured.rotor, pole_pairs_ * measured.speed};
  }
  /// Nothing: the encoder keeps the frame.
  void advance(const Vector& /*current*/) noexcept {}
  /// Frame of the rotor as voltages and currents show it.
  FrameOf<Number> observe(const MeasurementOf<Number>& measured) noexcept {
    observer_.step(measured);
    return observer_.frame();
  }
  /// Starts to observe on @p frame.
  void start_observer(const FrameOf<Number>& frame, const Vector& current) noexcept {
    observer_.start(frame, current);
  }
  /// Speed of the shaft in @p frame (rad/s).
  Number speed(const FrameOf<Number>& frame) const noexcept { return frame.frequency / pole_pairs_; }
  /// Torque (N·m) that a fed current of @p amplitude (A) can give.
  Number pull(const Number& amplitude) const noexcept { return 1.5 * pole_pairs_ * flux() * amplitude; }
  /// Angle by which the rotor lags behind a current of @p amplitude (A) that is fed to carry @p torque (N·m), as
  /// sine.
  Number lag(const Number& torque, const Number& amplitude) const noexcept {
    const Number most = pull(amplitude);
    return select<Number>(most > 0.0, bounded<Number>(torque / most, -0.9, 0.9), 0.0);
  }
  /// Current (A) across a fed one that damps the rotor's swinging about it; @p frame is that of the fed current.
  Number damping(const FrameOf<Number>& frame) noexcept {
    const Vector induced = observer_.induced();
    const Number turning = copysign(length(induced), cross(frame.direction, induced)) / observer_.followed_flux();
    swing_ += kControlPeriod / kSwingTime * (frame.frequency - turning - swing_);
    return damping_ * swing_;
  }

  /// Currents for @p torque (N·m) in a frame of @p frequency (electrical rad/s).
  [[gnu::always_inline]] Vector currents(const Number& torque, const Number& frequency) noexcept {
    const Vector wanted = reference_.currents(torque);
    const Condition<Number> near_limit = near_limit_.holds();
    if (!any(near_limit)) [[likely]]
      return setpoint_ = wanted;
    const Number room = reserve_.room();
    const Condition<Number> weakening =
        near_limit && norm(reference_.flux(wanted)) * frequency * frequency > room * room;
    weakening_ = weakening || (!near_limit && weakening_.holds());
    setpoint_ =
        any(weakening) ? select(weakening, reference_.weakened(wanted, room / abs(frequency)), wanted) : wanted;
    return setpoint_;
  }
  /// Voltage that rotation takes with @p current in @p frame, and the torque that it makes.
  FluxEffectOf<Number> effect(const Vector& current, const FrameOf<Number>& frame) const noexcept {
    return reference_.effect(current, frame.frequency);
  }
  /// Voltage controller and torque limit, every @p dt (s): @p demand is the square of the voltage that the current
  /// controllers want (V²), @p highest the longest one (V).
  void trim(double dt, const Number& demand, const Number& highest, const Number& frequency) noexcept {
    const Number drop = resistance_ * maximum<Number>(0.0, copysign(Number{1.0}, frequency) * setpoint_.im);
    reserve_.follow(dt, demand, highest, drop, weakening_.holds());
    const Condition<Number> near_limit =
        reference_.full_flux() * (abs(frequency) + speeding_up_) > reserve_.room();
    near_limit_ = near_limit;
    weakening_ = weakening_.holds() && near_limit;
    const Number fastest = maximum<Number>(abs(frequency), 1e-3);
    reachable_ = reference_.highest_torque(Number{reserve_.room() / fastest});
  }
  /// Torque that current and voltage allow now, either way (N·m).
  Number reachable() const noexcept { return reachable_; }
  Number torque(const Vector& current) const noexcept { return reference_.torque(current); }
  static Condition<Number> magnetised() noexcept { return Condition<Number>{true}; }
  Number flux() const noexcept { return reference_.magnet_flux(); }
  Number pole_pairs() const noexcept { return pole_pairs_; }
  /// The curves in @p lane become those of @p axis, which outlives that.
  void set_curves(std::size_t lane, const SynchronousField<double>& axis) noexcept {
    reference_.set_curves(lane, axis.reference_);
  }

 private:
  template <class Other>
  friend class SynchronousField;
  using Reference =
      std::conditional_t<std::is_same_v<Number, double>, SynchronousReference, SynchronousCurrents<Number>>;

  static constexpr double kSwingTime = 2e-3;  // s, the voltages of changing currents are not the rotor's

  VoltageReserve<Number> reserve_;
  SynchronousObserver<Number> observer_;
  Number pole_pairs_ = 1.0;
  Number resistance_ = 0.0;
  Number damping_ = 0.0;  // A·s, of the shaft's electrical speed
  Number reachable_ = 0.0;
  Vector setpoint_{};
  Number swing_ = 0.0;        // frequency of the frame less that of the rotor, smoothed (electrical rad/s)
  Number speeding_up_ = 0.0;  // most that the frequency gains until the next trim() (electrical rad/s)
  Flag<Number> near_limit_{Condition<Number>{true}};  // some torque would need the flux weakened
  Flag<Number> weakening_{};
  Reference reference_;
};

template <>
void SynchronousField<double>::configure(const MachineData& machine, const ControlSettings& settings) noexcept;
template <>
void SynchronousField<double>::start() noexcept;

extern template class FieldControl<SynchronousField<double>>;

}  // namespace motor
