#pragma once

#include <algorithm>
#include <cmath>

#include "motor/data/machine_data.hpp"
#include "motor/math/pair.hpp"
#include "motor/math/runge_kutta.hpp"

namespace motor {

/// Permanent-magnet synchronous machine in rotor coordinates. The flux linkages derive from one co-energy,
/// W' = L_d i_d²/2 + psi_f (1 - s(i_q)) i_d + L_q i_q²/2, so that saturation neither makes nor loses energy.
class SynchronousMachine {
 public:
  struct Rate;
  /// Current of the rotor frame: d, q (A).
  struct CircuitState {
    Pair current{};

    CircuitState moved(const Rate& rate, double h) const noexcept { return {current + h * rate.current}; }
  };
  /// Change of the current (A/s), and what the energies and the torque are made of.
  struct Rate {
    Pair current;
    Pair power;     ///< by components u·i, 2/3 of the electrical power (W)
    Pair heating;   ///< by components i² (A²)
    double torque;  ///< (N·m)

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_sum(a.current, b.current, c.current, d.current), stage_sum(a.power, b.power, c.power, d.power),
              stage_sum(a.heating, b.heating, c.heating, d.heating),
              stage_sum(a.torque, b.torque, c.torque, d.torque)};
    }
  };

  /// Its voltages and currents are those of the rotor frame.
  static constexpr bool kTurnsWithRotor = true;

  explicit SynchronousMachine(const MachineData& machine) noexcept;

  const CircuitState& state() const noexcept { return state_; }
  void set_state(const CircuitState& state) noexcept { state_ = state; }

  /// Temperatures of winding and magnets (°C).
  void set_temperatures(double winding, double rotor) noexcept;
  double pole_pairs() const noexcept { return pole_pairs_; }
  /// The smaller of both inductances (H).
  double least_inductance() const noexcept { return std::min(inductance_[0], inductance_[1]); }
  /// Amplitude of the voltage that it induces in open terminals at the mechanical speed @p w (V).
  double induced(double w) const noexcept { return std::abs(pole_pairs_ * w) * magnets_[0]; }
  /// Copper losses (J) of a step with the summed rates @p sum, @p weight from stage_weight().
  double losses(const Rate& sum, double weight) const noexcept {
    return 1.5 * weight * motor::sum(resistance_ * sum.heating);
  }
  /// Takes the currents away; what the field gives back (J).
  double cut() noexcept {
    const double released = stored();
    state_ = {};
    return released;
  }
  /// Rates without current.
  static Rate blocked_rate(const CircuitState&, double) noexcept { return {Pair{}, Pair{}, Pair{}, 0.0}; }
  static Pair current(const CircuitState& y) noexcept { return y.current; }
  /// Flux linkages of the rotor frame (V·s).
  Pair flux(const CircuitState& y) const noexcept {
    const Pair linear = inductance_ * y.current + magnets_;
    if (!is_saturated(y)) return linear;
    const Saturation s = saturation(y.current[1]);
    return linear - Pair{s.loss, s.slope * y.current[0]};
  }
  /// Torque in the air gap (N·m).
  double torque() const noexcept { return torque_factor_ * cross(flux(state_), state_.current); }
  /// Flux linkage of the d axis (V·s).
  double main_flux() const noexcept { return flux(state_)[0]; }
  /// Energy of the magnetic field above that of the magnets alone (J).
  double stored() const noexcept {
    const Pair i = state_.current;
    return 1.5 * (0.5 * sum(inductance_ * i * i) - saturation(i[1]).slope * i[0] * i[1]);
  }
  /// Whether saturation counts for the current @p y.
  bool is_saturated(const CircuitState& y) const noexcept {
    return y.current[1] * y.current[1] > saturation_start_;
  }
  /// Rates under the voltage @p u of the rotor frame (V) at the mechanical speed @p w (rad/s).
  template <bool Saturated = true>
  Rate rate(const CircuitState& y, Pair u, double w) const noexcept {
    if constexpr (Saturated) return saturated_rate(y, u, w);
    // The voltage equation divided by the inductances: all that does not depend on the state is in the factors.
    const Pair i = y.current;
    return {(inverse_inductance_ * u - damping_ * i) + both(w) * (exchange_ * swapped(i) + induction_), u * i,
            i * i, i[1] * (magnet_torque_ + reluctance_torque_ * i[0])};
  }

 private:
  /// What saturation takes: from the flux of the magnets (V·s), its derivatives by i_q (V·s/A, V·s/A²).
  struct Saturation {
    double loss = 0.0;
    double slope = 0.0;
    double curvature = 0.0;
  };
  Saturation saturation(double i_q) const noexcept;
  void set_factors() noexcept;
  Rate saturated_rate(const CircuitState& y, Pair u, double w) const noexcept;

  CircuitState state_{};
  Pair inductance_;          // d, q
  Pair inverse_inductance_;  // d, q
  Pair magnets_;             // flux linkage d, and none of q
  Pair signed_pole_pairs_;   // p, -p
  double pole_pairs_;
  double torque_factor_;
  double cold_resistance_;
  double cold_magnet_flux_;
  double temperature_coefficient_;
  Pair resistance_;                 // of one phase, twice
  Pair damping_{};                  // R/L (1/s)
  Pair exchange_{};                 // p L_q/L_d, -p L_d/L_q
  Pair induction_{};                // what the magnets induce: 0, -p psi_f/L_q (A)
  double magnet_torque_ = 0.0;      // of i_q (N·m/A)
  double reluctance_torque_ = 0.0;  // of i_d·i_q (N·m/A²)
  double saturation_start_;         // i_q² above which the flux falls (A²)
  double saturation_knee_;          // i_q² from which it falls with i_q² (A²)
  double saturation_end_;           // i_q² of the maximum current (A²)
  double saturation_gain_ = 0.0;    // share of the flux lost for each A²
};

}  // namespace motor
