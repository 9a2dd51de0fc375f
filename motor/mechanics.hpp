#pragma once

#include <algorithm>
#include <cmath>

#include "motor/load.hpp"
#include "motor/machine_data.hpp"

namespace motor {

/// Rotor and load as one mass with dry and viscous friction. Stable at any step; a shaft that stops stands exactly
/// still, and stays so under every torque below the dry friction.
class Mechanics {
 public:
  Mechanics(const MachineData& machine, const Load& load) noexcept
      : inertia_{machine.inertia + load.inertia},
        coulomb_{machine.coulomb_friction + load.coulomb_friction},
        viscous_{machine.viscous_friction + load.viscous_friction},
        fan_{load.fan_coefficient},
        load_torque_{load.constant_torque} {}

  /// Advances by @p dt (s) under the motor torque (N·m).
  void step(double dt, double torque) noexcept {
    const double rate = dt / inertia_;
    const double driven = speed_ + rate * (torque - load_torque_);
    const double stick = rate * coulomb_;
    // Without any dry friction the last trace of an exponential decay would never end.
    if (std::abs(driven) <= std::max(stick, kRestSpeed)) {
      speed_ = 0.0;
      return;
    }
    const double slowed = driven - std::copysign(stick, driven);
    speed_ = slowed / (1.0 + rate * (viscous_ + fan_ * std::abs(speed_)));
  }
  /// Replaces the constant load torque (N·m, positive against positive rotation).
  void set_load_torque(double torque) noexcept { load_torque_ = torque; }
  /// Speed of the shaft (rad/s).
  double speed() const noexcept { return speed_; }
  /// Rotor and load (kg·m²).
  double inertia() const noexcept { return inertia_; }
  /// Whether the shaft stands and stays where it is without motor torque.
  bool rests() const noexcept { return std::abs(speed_) <= 0.0 && std::abs(load_torque_) <= coulomb_; }

 private:
  static constexpr double kRestSpeed = 1e-9;  // rad/s, one revolution in 200 years

  double inertia_;
  double coulomb_;
  double viscous_;
  double fan_;
  double load_torque_;
  double speed_ = 0.0;
};

}  // namespace motor
