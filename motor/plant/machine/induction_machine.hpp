#pragma once

#include <cmath>

#include "motor/data/machine_data.hpp"
#include "motor/math/pair.hpp"
#include "motor/math/runge_kutta.hpp"
#include "motor/math/space_vector.hpp"

namespace motor {

/// Induction machine as inverse-Gamma circuit in the stator frame: the same at the terminals as the T circuit,
/// without its redundant leakage. The held voltage of an inverter is exactly constant there.
class InductionMachine {
 public:
  struct Rate;
  /// Flux linkages of the stator frame (V·s).
  struct CircuitState {
    Pair stator{};
    Pair rotor{};

    CircuitState moved(const Rate& rate, double h) const noexcept {
      return {stator + h * rate.stator, rotor + h * rate.rotor};
    }
  };
  /// Change of the fluxes (V), and what the energies and the torque are made of.
  struct Rate {
    Pair stator;
    Pair rotor;
    Pair power;          ///< by components u·i, 2/3 of the electrical power (W)
    Pair heating;        ///< squares of the stator current (A²)
    Pair rotor_heating;  ///< squares of the rotor current (A²)
    double torque;       ///< (N·m)

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_sum(a.stator, b.stator, c.stator, d.stator),
              stage_sum(a.rotor, b.rotor, c.rotor, d.rotor),
              stage_sum(a.power, b.power, c.power, d.power),
              stage_sum(a.heating, b.heating, c.heating, d.heating),
              stage_sum(a.rotor_heating, b.rotor_heating, c.rotor_heating, d.rotor_heating),
              stage_sum(a.torque, b.torque, c.torque, d.torque)};
    }
  };

  /// Its voltages and currents are those of the stator frame.
  static constexpr bool kTurnsWithRotor = false;

  explicit InductionMachine(const MachineData& machine) noexcept;

  const CircuitState& state() const noexcept { return state_; }
  void set_state(const CircuitState& state) noexcept { state_ = state; }
  /// Temperatures of winding and rotor (°C).
  void set_temperatures(double winding, double rotor) noexcept;
  double pole_pairs() const noexcept { return pole_pairs_; }
  /// Inductance that limits the change of the current (H).
  double least_inductance() const noexcept { return 1.0 / inverse_leakage_; }
  /// Amplitude of the voltage that the rotor flux induces in open terminals at the mechanical speed @p w (V).
  double induced(double w) const noexcept { return length(vector(blocked_rate(state_, w).rotor)); }
  /// Copper losses (J) of a step with the summed rates @p sum, @p weight from stage_weight().
  double losses(const Rate& sum, double weight) const noexcept {
    return 1.5 * weight *
           (stator_resistance_ * motor::sum(sum.heating) + rotor_resistance_ * motor::sum(sum.rotor_heating));
  }
  /// Takes the stator current away; what its field gives back (J).
  double cut() noexcept;
  Pair current(const CircuitState& y) const noexcept { return inverse_leakage_ * (y.stator - y.rotor); }
  /// Torque in the air gap (N·m).
  double torque() const noexcept { return torque_factor_ * cross(state_.rotor, current(state_)); }
  /// Length of the rotor flux linkage (V·s).
  double main_flux() const noexcept { return length(vector(state_.rotor)); }
  /// Energy of the magnetic field (J).
  double stored() const noexcept;
  /// Rates under the voltage @p u of the stator frame (V) at the mechanical speed @p w (rad/s).
  Rate rate(const CircuitState& y, Pair u, double w) const noexcept {
    const Pair i = current(y);
    const Pair slip = reluctance(dot(y.rotor, y.rotor)) * y.rotor - i;  // rotor current, reversed
    return {u - stator_resistance_ * i,
            turned(y.rotor, w) - rotor_resistance_ * slip,
            u * i,
            i * i,
            slip * slip,
            torque_factor_ * cross(y.rotor, i)};
  }
  /// Rates without stator current: the rotor flux turns on and fades.
  Rate blocked_rate(const CircuitState& y, double w) const noexcept;

 private:
  /// What the rotor flux changes by because the rotor turns.
  Pair turned(Pair flux, double w) const noexcept { return both(w) * signed_pole_pairs_ * swapped(flux); }
  /// 1/L_M at the square of the rotor flux (1/H).
  double reluctance(double square) const noexcept {
    return reluctance_ * (1.0 + saturation_ * square * square * square);
  }

  CircuitState state_{};
  Pair signed_pole_pairs_;  // -p, p
  double pole_pairs_;
  double torque_factor_;
  double inverse_leakage_;
  double reluctance_;  // 1/L_M without saturation
  double saturation_;  // 1/(V·s)^6
  double cold_stator_resistance_;
  double cold_rotor_resistance_;
  double stator_resistance_ = 0.0;
  double rotor_resistance_ = 0.0;
};

}  // namespace motor
