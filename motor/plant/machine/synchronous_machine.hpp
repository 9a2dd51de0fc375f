#pragma once

#include <algorithm>
#include <cmath>

#include "motor/data/machine_data.hpp"
#include "motor/plant/machine/synchronous_equations.hpp"

namespace motor {

/// A permanent-magnet machine that warms: the equations with its data.
class SynchronousMachine : public SynchronousEquations<double> {
 public:
  using Equations = SynchronousEquations<double>;

  explicit SynchronousMachine(const MachineData& machine) noexcept;

  /// Temperatures of winding and magnets (°C).
  void set_temperatures(double winding, double rotor) noexcept;
  /// The smaller of both inductances (H).
  double least_inductance() const noexcept { return std::min(inductance_[0], inductance_[1]); }
  /// Amplitude of the voltage that it induces in open terminals at the mechanical speed @p w (V).
  double induced(double w) const noexcept { return std::abs(pole_pairs_ * w) * magnets_[0]; }
  /// Takes the currents away; what the field gives back (J).
  double cut() noexcept {
    const double released = stored();
    state_ = {};
    return released;
  }
  /// Rates without current.
  static Rate blocked_rate(const CircuitState&, double) noexcept { return {Pair{}, Pair{}, Pair{}, 0.0}; }
  /// Energy of the magnetic field above that of the magnets alone (J).
  double stored() const noexcept {
    const Pair i = state_.current;
    return 1.5 * (0.5 * sum(inductance_ * i * i) - saturation(i[1]).slope * i[0] * i[1]);
  }

 private:
  void set_factors() noexcept;

  double cold_resistance_;
  double cold_magnet_flux_;
  double temperature_coefficient_;
};

}  // namespace motor
