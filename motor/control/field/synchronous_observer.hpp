#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motor/control/measurement.hpp"
#include "motor/data/machine_data.hpp"
#include "motor/math/frame.hpp"

namespace motor {

/// Finds angle and speed of a permanent-magnet rotor from voltages and currents: what the voltage of a period
/// leaves after the resistance and the flux of the current is the change of the magnets' flux, and a phase-locked
/// loop follows its direction. Without speed there is nothing to see.
template <class Number>
class SynchronousObserver {
 public:
  /// Bandwidth of the loop (rad/s) a rad/s of speed. Where the inductances differ, the current's part of the flux
  /// makes the loop see itself, which a slow one can bear.
  static double bandwidth_share(const MachineData& machine) noexcept {
    const SynchronousData& data = machine.synchronous;
    const double current = std::numbers::sqrt2 * machine.maximum_current;
    const double seen = 2.0 * std::abs(data.q_inductance - data.d_inductance) * current;
    return data.magnet_flux / std::max(seen, kLeastSeen * data.magnet_flux);
  }
  /// Bandwidth of the loop (rad/s) at @p frequency (electrical rad/s).
  static Number bandwidth(const Number& share, const Number& frequency) noexcept {
    return bounded<Number>(share * abs(frequency), kLowest, kHighest);
  }
  void configure(const MachineData& machine, double period) noexcept {
    bandwidth_share_ = bandwidth_share(machine);
    resistance_ = machine.stator_resistance;
    inductance_ = machine.synchronous.q_inductance;
    saliency_ = machine.synchronous.d_inductance - inductance_;
    flux_ = machine.synchronous.magnet_flux;
    period_ = period;
  }
  /// Starts on @p frame with the present @p current (A).
  void start(const FrameOf<Number>& frame, const SpaceVectorOf<Number>& current) noexcept {
    frame_ = frame;
    current_ = current;
  }
  /// Takes in the period that ends now.
  void step(const MeasurementOf<Number>& measured) noexcept {
    const SpaceVectorOf<Number> mean = 0.5 * (measured.current + current_);
    const SpaceVectorOf<Number> change = (inductance_ / period_) * (measured.current - current_);
    induced_ = measured.voltage - resistance_ * mean - change;
    const Number d_before = dot(current_, frame_.direction);
    current_ = measured.current;
    const SpaceVectorOf<Number> half_turn = bounded_rotation<Number>(0.5 * period_ * frame_.frequency);
    const SpaceVectorOf<Number> middle = frame_.direction * half_turn;
    const SpaceVectorOf<Number> seen = induced_ * conjugate(middle);
    // With unlike inductances the flux to be followed has a part of the current along it, whose changes are no
    // rotation.
    const Number d_current = dot(current_, middle * half_turn);
    const Number along = seen.re - saliency_ / period_ * (d_current - d_before);
    followed_flux_ = flux_ + saliency_ * d_current;
    const Number scale = maximum<Number>(abs(frame_.frequency) * followed_flux_, kLeastVoltage);
    const Number error = bounded<Number>(-copysign(Number{1.0}, frame_.frequency) * along / scale, -1.0, 1.0);
    const Number rate = bandwidth(bandwidth_share_, frame_.frequency);
    frame_.frequency += rate * rate * period_ * error;
    frame_.direction = turned<Number>(frame_.direction, period_ * (frame_.frequency + 2.0 * rate * error));
  }
  /// Where the magnets point, and how fast they turn.
  const FrameOf<Number>& frame() const noexcept { return frame_; }
  /// Flux that turns with the rotor: that of the magnets, and with unlike inductances a part of the current's
  /// (V·s).
  Number followed_flux() const noexcept { return followed_flux_; }
  /// Voltage that the magnets induce, mean of the last period, stator frame (V).
  SpaceVectorOf<Number> induced() const noexcept { return induced_; }

 private:
  static constexpr double kLeastSeen = 0.02;
  static constexpr double kLowest = 50.0;       // rad/s
  static constexpr double kHighest = 400.0;     // rad/s
  static constexpr double kLeastVoltage = 1.0;  // V

  Number bandwidth_share_ = 1.0;
  Number resistance_ = 0.0;
  Number inductance_ = 0.0;
  Number saliency_ = 0.0;  // H
  Number flux_ = 0.0;
  Number followed_flux_ = 1.0;
  Number period_ = 0.0;
  FrameOf<Number> frame_{};
  SpaceVectorOf<Number> current_{};
  SpaceVectorOf<Number> induced_{};
};

}  // namespace motor
