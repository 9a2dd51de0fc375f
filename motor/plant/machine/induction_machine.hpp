#pragma once

#include "motor/data/machine_data.hpp"
#include "motor/plant/machine/induction_equations.hpp"

namespace motor {

/// An induction machine that warms: the equations with its data.
class InductionMachine : public InductionEquations<double> {
 public:
  using Equations = InductionEquations<double>;

  explicit InductionMachine(const MachineData& machine) noexcept;

  /// Temperatures of winding and rotor (°C).
  void set_temperatures(double winding, double rotor) noexcept;
  /// Inductance that limits the change of the current (H).
  double least_inductance() const noexcept { return 1.0 / inverse_leakage_; }
  /// Amplitude of the voltage that the rotor flux induces in open terminals at the mechanical speed @p w (V).
  double induced(double w) const noexcept { return length(vector(blocked_rate(state_, w).rotor)); }
  /// Takes the stator current away; what its field gives back (J).
  double cut() noexcept;
  /// Energy of the magnetic field (J).
  double stored() const noexcept;
  /// Rates without stator current: the rotor flux turns on and fades.
  Rate blocked_rate(const CircuitState& y, double w) const noexcept;

 private:
  double cold_stator_resistance_;
  double cold_rotor_resistance_;
};

}  // namespace motor
