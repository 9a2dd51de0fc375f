#pragma once

#include <algorithm>
#include <cmath>

#include "motor/control/control_settings.hpp"
#include "motor/control/field/induction_circuit.hpp"
#include "motor/control/field/voltage_reserve.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// An induction machine as its field-oriented control sees it. With an encoder the rotor flux follows from
/// currents and speed, without one from voltages and currents. Currents and voltages are those of the flux frame.
class InductionField {
 public:
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
  Frame frame(const Measurement& measured) noexcept {
    const SpaceVector current = measured.current * conjugate(frame_.direction);
    frame_.frequency = pole_pairs_ * measured.speed + slip(current.im);
    return frame_;
  }
  /// Goes on to the next period with @p current in the present frame.
  void advance(SpaceVector current) noexcept {
    flux_ += kControlPeriod * (circuit_.rotor_resistance * current.re - decay_ * flux_);
    frame_.direction = turned(frame_.direction, kControlPeriod * frame_.frequency);
  }
  /// Frame of the rotor flux as voltages and currents show it.
  Frame observe(const Measurement& measured) noexcept;
  /// Starts to observe on @p frame.
  void start_observer(const Frame& frame, SpaceVector current) noexcept;
  /// Speed of the shaft in the frame last observed (rad/s).
  double speed(const Frame& /*frame*/) const noexcept { return electrical_speed_ / pole_pairs_; }
  /// Torque (N·m) that a fed current of @p amplitude (A) can give.
  double pull(double amplitude) const noexcept {
    return 0.5 * torque_factor_ * standing_flux(circuit_, amplitude) * amplitude;
  }
  /// The flux follows a fed current by itself.
  static double lag(double /*torque*/, double /*amplitude*/) noexcept { return 0.0; }
  static double damping(const Frame& /*frame*/) noexcept { return 0.0; }

  /// Currents for @p torque (N·m) and the flux that voltage and speed allow.
  SpaceVector currents(double torque, double frequency) noexcept;
  /// Voltage that rotation takes with @p current in @p frame, and the torque that it makes.
  FluxEffect effect(SpaceVector current, const Frame& frame) const noexcept {
    const double across = frame.frequency * circuit_.leakage;
    const double turning = frame.frequency - slip(current.im);
    return {{-across * current.im - decay_ * flux_, across * current.re + turning * flux_}, torque(current)};
  }
  /// Voltage controller, saturation and torque limit, every @p dt (s), as for SynchronousField.
  void trim(double dt, double demand, double highest, double frequency) noexcept;
  double reachable() const noexcept { return reachable_; }
  double torque(SpaceVector current) const noexcept { return torque_factor_ * flux_ * current.im; }
  /// Whether the flux has been built up since the pulses came.
  bool magnetised() const noexcept { return magnetised_; }
  double flux() const noexcept { return flux_; }

 private:
  double usable_flux() const noexcept { return std::max(flux_, kLeastFlux * rated_flux_); }
  double slip(double current) const noexcept { return circuit_.rotor_resistance * current / usable_flux(); }

  static constexpr double kLeastFlux = 0.1;  // of the rated one
  static constexpr double kGone = 1e-3;      // of the rated one

  InductionCircuit circuit_;
  VoltageReserve reserve_;
  double pole_pairs_ = 1.0;
  double torque_factor_ = 1.5;  // 1.5 pole pairs
  double current_limit_ = 1.0;  // A
  double full_flux_ = 1.0;      // rated one (V·s)
  double flux_share_ = 1.0;
  double rated_flux_ = 1.0;  // what is kept below field weakening (V·s)
  double decay_ = 1.0;       // R_R/L_M at the present flux (1/s)
  double inductance_ = 1.0;  // L_M at the present flux (H)
  Frame frame_{};
  double flux_ = 0.0;       // V·s
  double goal_ = 0.0;       // flux setpoint (V·s)
  double reachable_ = 0.0;  // N·m
  double electrical_speed_ = 0.0;
  SpaceVector current_{};  // of the last period, stator frame
  SpaceVector setpoint_{};
  bool weakening_ = false;
  bool magnetised_ = false;
  bool with_encoder_ = true;
};

}  // namespace motor
