#pragma once

#include <algorithm>
#include <cmath>

#include "motor/machine_data.hpp"
#include "motor/runge_kutta.hpp"
#include "motor/space_vector.hpp"

namespace motor {

/// Permanent-magnet synchronous machine in rotor coordinates. The flux linkages derive from one co-energy,
/// W' = L_d i_d²/2 + psi_f (1 - s(i_q)) i_d + L_q i_q²/2, so that saturation neither makes nor loses energy.
class SynchronousMachine {
 public:
  struct Rate;
  /// Currents of the rotor frame (A).
  struct State {
    double i_d = 0.0;
    double i_q = 0.0;

    State moved(const Rate& rate, double h) const noexcept { return {i_d + h * rate.i_d, i_q + h * rate.i_q}; }
  };
  /// Change of the currents (A/s), and what the energies and the torque are made of.
  struct Rate {
    double i_d;
    double i_q;
    double torque;   ///< (N·m)
    double power;    ///< u·i, 2/3 of the electrical power (W)
    double heating;  ///< |i|² (A²)

    static Rate mean(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_mean(a.i_d, b.i_d, c.i_d, d.i_d), stage_mean(a.i_q, b.i_q, c.i_q, d.i_q),
              stage_mean(a.torque, b.torque, c.torque, d.torque), stage_mean(a.power, b.power, c.power, d.power),
              stage_mean(a.heating, b.heating, c.heating, d.heating)};
    }
  };

  /// Its voltages and currents are those of the rotor frame.
  static constexpr bool kTurnsWithRotor = true;

  explicit SynchronousMachine(const MachineData& machine) noexcept;

  const State& state() const noexcept { return state_; }
  void set_state(const State& state) noexcept { state_ = state; }

  /// Temperatures of winding and magnets (°C).
  void set_temperatures(double winding, double rotor) noexcept;
  double pole_pairs() const noexcept { return pole_pairs_; }
  /// The smaller of both inductances (H).
  double least_inductance() const noexcept { return std::min(l_d_, l_q_); }
  /// Amplitude of the voltage that it induces in open terminals at the mechanical speed @p w (V).
  double induced(double w) const noexcept { return std::abs(pole_pairs_ * w) * magnet_flux_; }
  /// Copper losses of a step with the mean rates @p mean (W).
  double losses(const Rate& mean) const noexcept { return 1.5 * resistance_ * mean.heating; }
  /// Takes the currents away; what the field gives back (J).
  double cut() noexcept {
    const double released = stored();
    state_ = {};
    return released;
  }
  /// Rates without current.
  Rate blocked_rate(const State&, double) const noexcept { return {}; }
  SpaceVector current(const State& y) const noexcept { return {y.i_d, y.i_q}; }
  /// Flux linkages of the rotor frame (V·s).
  SpaceVector flux(const State& y) const noexcept {
    const Saturation s = saturation(y.i_q);
    return {l_d_ * y.i_d + magnet_flux_ - s.loss, l_q_ * y.i_q - s.slope * y.i_d};
  }
  /// Torque in the air gap (N·m).
  double torque() const noexcept { return torque_factor_ * cross(flux(state_), current(state_)); }
  /// Flux linkage of the d axis (V·s).
  double main_flux() const noexcept { return flux(state_).re; }
  /// Energy of the magnetic field above that of the magnets alone (J).
  double stored() const noexcept {
    const State& y = state_;
    const double cross_term = saturation(y.i_q).slope * y.i_d * y.i_q;
    return 1.5 * (0.5 * (l_d_ * y.i_d * y.i_d + l_q_ * y.i_q * y.i_q) - cross_term);
  }
  /// Rates under the voltage @p u of the rotor frame (V) at the mechanical speed @p w (rad/s).
  Rate rate(const State& y, SpaceVector u, double w) const noexcept {
    const double w_e = pole_pairs_ * w;
    const double square = y.i_q * y.i_q;
    if (square > saturation_start_) [[unlikely]]
      return saturated_rate(y, u, w_e);
    const double psi_d = l_d_ * y.i_d + magnet_flux_;
    const double psi_q = l_q_ * y.i_q;
    return {(u.re - resistance_ * y.i_d + w_e * psi_q) * inverse_l_d_,
            (u.im - resistance_ * y.i_q - w_e * psi_d) * inverse_l_q_,
            torque_factor_ * (psi_d * y.i_q - psi_q * y.i_d), u.re * y.i_d + u.im * y.i_q, y.i_d * y.i_d + square};
  }

 private:
  /// What saturation takes: from the flux of the magnets (V·s), its derivatives by i_q (V·s/A, V·s/A²).
  struct Saturation {
    double loss = 0.0;
    double slope = 0.0;
    double curvature = 0.0;
  };
  Saturation saturation(double i_q) const noexcept;
  Rate saturated_rate(const State& y, SpaceVector u, double w_e) const noexcept;

  State state_{};
  double pole_pairs_;
  double torque_factor_;
  double l_d_;
  double l_q_;
  double inverse_l_d_;
  double inverse_l_q_;
  double cold_resistance_;
  double cold_magnet_flux_;
  double temperature_coefficient_;
  double resistance_;
  double magnet_flux_;
  double saturation_start_;       // i_q² above which the flux falls (A²)
  double saturation_knee_;        // i_q² from which it falls with i_q² (A²)
  double saturation_end_;         // i_q² of the maximum current (A²)
  double saturation_gain_ = 0.0;  // share of the flux lost for each A²
};

}  // namespace motor
