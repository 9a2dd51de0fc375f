#pragma once

#include <cmath>

#include "motor/machine_data.hpp"
#include "motor/runge_kutta.hpp"
#include "motor/space_vector.hpp"

namespace motor {

/// Induction machine as inverse-Gamma circuit in the stator frame: the same at the terminals as the T circuit,
/// without its redundant leakage. The held voltage of an inverter is exactly constant there.
class InductionMachine {
 public:
  struct Rate;
  /// Flux linkages of the stator frame (V·s).
  struct State {
    SpaceVector stator{};
    SpaceVector rotor{};

    State moved(const Rate& rate, double h) const noexcept {
      return {stator + h * rate.stator, rotor + h * rate.rotor};
    }
  };
  /// Change of the fluxes (V), and what the energies and the torque are made of.
  struct Rate {
    SpaceVector stator;
    SpaceVector rotor;
    double torque;         ///< (N·m)
    double power;          ///< u·i, 2/3 of the electrical power (W)
    double heating;        ///< square of the stator current (A²)
    double rotor_heating;  ///< square of the rotor current (A²)

    static Rate mean(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {{stage_mean(a.stator.re, b.stator.re, c.stator.re, d.stator.re),
               stage_mean(a.stator.im, b.stator.im, c.stator.im, d.stator.im)},
              {stage_mean(a.rotor.re, b.rotor.re, c.rotor.re, d.rotor.re),
               stage_mean(a.rotor.im, b.rotor.im, c.rotor.im, d.rotor.im)},
              stage_mean(a.torque, b.torque, c.torque, d.torque),
              stage_mean(a.power, b.power, c.power, d.power),
              stage_mean(a.heating, b.heating, c.heating, d.heating),
              stage_mean(a.rotor_heating, b.rotor_heating, c.rotor_heating, d.rotor_heating)};
    }
  };

  /// Its voltages and currents are those of the stator frame.
  static constexpr bool kTurnsWithRotor = false;

  explicit InductionMachine(const MachineData& machine) noexcept;

  const State& state() const noexcept { return state_; }
  void set_state(const State& state) noexcept { state_ = state; }
  /// Temperatures of winding and rotor (°C).
  void set_temperatures(double winding, double rotor) noexcept;
  double pole_pairs() const noexcept { return pole_pairs_; }
  /// Inductance that limits the change of the current (H).
  double least_inductance() const noexcept { return 1.0 / inverse_leakage_; }
  /// Amplitude of the voltage that the rotor flux induces in open terminals at the mechanical speed @p w (V).
  double induced(double w) const noexcept { return length(blocked_rate(state_, w).rotor); }
  /// Copper losses of a step with the mean rates @p mean (W).
  double losses(const Rate& mean) const noexcept {
    return 1.5 * (stator_resistance_ * mean.heating + rotor_resistance_ * mean.rotor_heating);
  }
  /// Takes the stator current away; what its field gives back (J).
  double cut() noexcept;
  SpaceVector current(const State& y) const noexcept { return inverse_leakage_ * (y.stator - y.rotor); }
  /// Torque in the air gap (N·m).
  double torque() const noexcept { return torque_factor_ * cross(state_.rotor, current(state_)); }
  /// Length of the rotor flux linkage (V·s).
  double main_flux() const noexcept { return length(state_.rotor); }
  /// Energy of the magnetic field (J).
  double stored() const noexcept;
  /// Rates under the voltage @p u of the stator frame (V) at the mechanical speed @p w (rad/s).
  Rate rate(const State& y, SpaceVector u, double w) const noexcept {
    const SpaceVector i = current(y);
    const SpaceVector slip = reluctance(norm(y.rotor)) * y.rotor - i;  // rotor current, reversed
    const double w_e = pole_pairs_ * w;
    return {u - stator_resistance_ * i,
            {-rotor_resistance_ * slip.re - w_e * y.rotor.im, -rotor_resistance_ * slip.im + w_e * y.rotor.re},
            torque_factor_ * cross(y.rotor, i),
            dot(u, i),
            norm(i),
            norm(slip)};
  }
  /// Rates without stator current: the rotor flux turns on and fades.
  Rate blocked_rate(const State& y, double w) const noexcept;

 private:
  /// 1/L_M at the square of the rotor flux (1/H).
  double reluctance(double square) const noexcept {
    return reluctance_ * (1.0 + saturation_ * square * square * square);
  }

  State state_{};
  double pole_pairs_;
  double torque_factor_;
  double inverse_leakage_;
  double reluctance_;  // 1/L_M without saturation
  double saturation_;  // 1/(V·s)^6
  double cold_stator_resistance_;
  double cold_rotor_resistance_;
  double stator_resistance_;
  double rotor_resistance_;
};

}  // namespace motor
