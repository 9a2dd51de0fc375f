#pragma once

#include <cmath>
#include <cstdint>

#include "motor/data/machine_data.hpp"
#include "motor/math/curve.hpp"
#include "motor/math/frame.hpp"
#include "motor/math/space_vector.hpp"
#include "motor/plant/machine/synchronous_machine.hpp"

namespace motor {

/// Which currents a permanent-magnet machine needs for a torque: as few as possible (MTPA) as long as the voltage
/// suffices, above that with the flux weakened along the ellipse that the voltage leaves.
class SynchronousReference {
 public:
  /// Computes the curves for @p machine up to @p current_limit (A peak, positive), unless they are those already.
  void configure(const MachineData& machine, double current_limit) noexcept;

  /// Currents (A) for @p torque (N·m) while no voltage limits them.
  SpaceVector currents(double torque) const noexcept {
    const double amount = std::abs(torque);
    return {salient_ ? d_current_.at(amount) : 0.0, std::copysign(q_current_.at(amount), torque)};
  }
  /// The same with the stator flux kept below @p limit (V·s, positive); @p wanted is what currents() gave.
  SpaceVector weakened(SpaceVector wanted, double limit) const noexcept;
  /// Flux of the stator with @p current (V·s).
  SpaceVector flux(SpaceVector current) const noexcept {
    return {d_inductance_ * current.re + magnet_flux_, q_inductance_ * current.im};
  }
  /// Torque that the machine's data promise for @p current (N·m).
  double torque(SpaceVector current) const noexcept {
    return torque_factor_ * cross(model_.flux({pair(current)}), pair(current));
  }
  /// What the flux does that @p current makes with the magnets, at @p frequency (electrical rad/s).
  FluxEffect effect(SpaceVector current, double frequency) const noexcept {
    const Pair flux = model_.flux({pair(current)});
    return {vector(Pair{-frequency, frequency} * swapped(flux)), torque_factor_ * cross(flux, pair(current))};
  }
  /// Highest torque with the current limit alone (N·m).
  double highest_torque() const noexcept { return highest_torque_; }
  /// Highest torque with the stator flux below @p flux (V·s) too (N·m).
  double highest_torque(double flux) const noexcept { return torque_by_flux_.at(flux); }
  /// Stator flux at the highest torque (V·s): below it the flux begins to limit.
  double full_flux() const noexcept { return full_flux_; }
  /// Flux of the magnets (V·s).
  double magnet_flux() const noexcept { return magnet_flux_; }
  double d_inductance() const noexcept { return d_inductance_; }
  double q_inductance() const noexcept { return q_inductance_; }

 private:
  /// What the curves depend on.
  struct Source {
    SynchronousData data{};
    std::uint8_t pole_pairs = 0;
    double stall_current = 0.0;    // A rms
    double maximum_current = 0.0;  // A rms
    double current_limit = 0.0;    // A peak

    friend bool operator==(const Source&, const Source&) = default;
  };

  void compute() noexcept;
  SpaceVector cheapest(double current) const noexcept;
  double current_for(double wanted) const noexcept;
  double limited_by(double limit) const noexcept;
  SpaceVector at_limits(double limit) const noexcept;
  SpaceVector least_flux_per_torque(double limit) const noexcept;

  Source source_{};
  SynchronousMachine model_{MachineData{}};  // cold
  double torque_factor_ = 1.5;               // 1.5 pole pairs
  double d_inductance_ = 1e-3;               // H
  double q_inductance_ = 1e-3;               // H
  double magnet_flux_ = 0.1;                 // V·s
  double current_limit_ = 1.0;               // A
  double highest_torque_ = 0.0;
  double full_flux_ = 0.0;
  bool salient_ = false;
  Curve d_current_;       // by torque
  Curve q_current_;       // by torque
  Curve torque_by_flux_;  // by stator flux
};

}  // namespace motor
