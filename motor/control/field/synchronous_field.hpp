#pragma once

#include "motor/control/control_settings.hpp"
#include "motor/control/field/synchronous_observer.hpp"
#include "motor/control/field/synchronous_reference.hpp"
#include "motor/control/field/voltage_reserve.hpp"
#include "motor/control/measurement.hpp"
#include "motor/control/signals.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// A permanent-magnet machine as its field-oriented control sees it: where the flux is, which currents give a
/// torque there, and which voltage they need. Currents and voltages are those of the rotor frame.
class SynchronousField {
 public:
  void configure(const MachineData& machine, const ControlSettings& settings) noexcept;
  /// Nothing: the flux of magnets is what it is.
  static void set_flux_share(double /*share*/) noexcept {}
  /// Pulses come.
  void start() noexcept;
  /// One period with the pulses off: nothing changes.
  void coast(double /*speed*/) noexcept {}

  /// Frame of the rotor as the encoder sees it.
  Frame frame(const Measurement& measured) const noexcept {
    return {measured.rotor, pole_pairs_ * measured.speed};
  }
  /// Nothing: the encoder keeps the frame.
  void advance(SpaceVector /*current*/) noexcept {}
  /// Frame of the rotor as voltages and currents show it.
  Frame observe(const Measurement& measured) noexcept {
    observer_.step(measured);
    return observer_.frame();
  }
  /// Starts to observe on @p frame.
  void start_observer(const Frame& frame, SpaceVector current) noexcept { observer_.start(frame, current); }
  /// Speed of the shaft in @p frame (rad/s).
  double speed(const Frame& frame) const noexcept { return frame.frequency / pole_pairs_; }
  /// Torque (N·m) that a fed current of @p amplitude (A) can give.
  double pull(double amplitude) const noexcept { return 1.5 * pole_pairs_ * flux() * amplitude; }
  /// Angle by which the rotor lags behind a current of @p amplitude (A) that is fed to carry @p torque (N·m), as
  /// sine.
  double lag(double torque, double amplitude) const noexcept;
  /// Current (A) across a fed one that damps the rotor's swinging about it; @p frame is that of the fed current.
  double damping(const Frame& frame) noexcept;

  /// Currents for @p torque (N·m) in a frame of @p frequency (electrical rad/s).
  [[gnu::always_inline]] SpaceVector currents(double torque, double frequency) noexcept {
    const SpaceVector wanted = reference_.currents(torque);
    if (!near_limit_) [[likely]]
      return setpoint_ = wanted;
    const double room = reserve_.room();
    weakening_ = norm(reference_.flux(wanted)) * frequency * frequency > room * room;
    setpoint_ = weakening_ ? reference_.weakened(wanted, room / std::abs(frequency)) : wanted;
    return setpoint_;
  }
  /// Voltage that rotation takes with @p current in @p frame, and the torque that it makes.
  FluxEffect effect(SpaceVector current, const Frame& frame) const noexcept {
    return reference_.effect(current, frame.frequency);
  }
  /// Voltage controller and torque limit, every @p dt (s): @p demand is the square of the voltage that the current
  /// controllers want (V²), @p highest the longest one (V).
  void trim(double dt, double demand, double highest, double frequency) noexcept;
  /// Torque that current and voltage allow now, either way (N·m).
  double reachable() const noexcept { return reachable_; }
  double torque(SpaceVector current) const noexcept { return reference_.torque(current); }
  static bool magnetised() noexcept { return true; }
  double flux() const noexcept { return reference_.magnet_flux(); }

 private:
  SynchronousReference reference_;
  VoltageReserve reserve_;
  SynchronousObserver observer_;
  double pole_pairs_ = 1.0;
  double resistance_ = 0.0;
  double damping_ = 0.0;  // A·s, of the shaft's electrical speed
  double current_limit_ = 0.0;
  double reachable_ = 0.0;
  SpaceVector setpoint_{};
  double swing_ = 0.0;        // frequency of the frame less that of the rotor, smoothed (electrical rad/s)
  double speeding_up_ = 0.0;  // most that the frequency gains until the next trim() (electrical rad/s)
  bool near_limit_ = true;    // some torque would need the flux weakened
  bool weakening_ = false;
};

}  // namespace motor
