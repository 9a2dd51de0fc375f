#pragma once

#include <cstddef>

#include "motor/math/pair.hpp"
#include "motor/math/runge_kutta.hpp"

namespace motor {

/// Induction machine as inverse-Gamma circuit in the stator frame: the same at the terminals as the T circuit,
/// without its redundant leakage. The held voltage of an inverter is exactly constant there.
template <class Number>
class InductionEquations {
 public:
  using Components = PairOf<Number>;
  struct Rate;
  /// Flux linkages of the stator frame (V·s).
  struct CircuitState {
    Components stator{};
    Components rotor{};

    CircuitState moved(const Rate& rate, const Number& h) const noexcept {
      return {stator + h * rate.stator, rotor + h * rate.rotor};
    }
  };
  /// Change of the fluxes (V), and what the energies and the torque are made of.
  struct Rate {
    Components stator;
    Components rotor;
    Components power;          ///< by components u·i, 2/3 of the electrical power (W)
    Components heating;        ///< squares of the stator current (A²)
    Components rotor_heating;  ///< squares of the rotor current (A²)
    Number torque;             ///< (N·m)

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_sum(a.stator, b.stator, c.stator, d.stator),
              stage_sum(a.rotor, b.rotor, c.rotor, d.rotor),
              stage_sum(a.power, b.power, c.power, d.power),
              stage_sum(a.heating, b.heating, c.heating, d.heating),
              stage_sum(a.rotor_heating, b.rotor_heating, c.rotor_heating, d.rotor_heating),
              stage_sum(a.torque, b.torque, c.torque, d.torque)};
    }
  };

  /// Numbers that a step changes; they come first.
  static constexpr std::size_t kChanging = 4;
  /// Its voltages and currents are those of the stator frame.
  static constexpr bool kTurnsWithRotor = false;
  /// Its saturation grows without a bend.
  static constexpr bool kHasBend = false;

  const CircuitState& state() const noexcept { return state_; }
  void set_state(const CircuitState& state) noexcept { state_ = state; }
  Number pole_pairs() const noexcept { return pole_pairs_; }
  /// Copper losses (J) of a step with the summed rates @p sum, @p weight from stage_weight().
  Number losses(const Rate& sum, const Number& weight) const noexcept {
    return 1.5 * weight *
           (stator_resistance_ * motor::sum(sum.heating) + rotor_resistance_ * motor::sum(sum.rotor_heating));
  }
  Components current(const CircuitState& y) const noexcept { return inverse_leakage_ * (y.stator - y.rotor); }
  /// Torque in the air gap (N·m).
  Number torque() const noexcept { return torque_factor_ * cross(state_.rotor, current(state_)); }
  /// Length of the rotor flux linkage (V·s).
  Number main_flux() const noexcept { return length(vector(state_.rotor)); }
  /// Rates under the voltage @p u of the stator frame (V) at the mechanical speed @p w (rad/s).
  Rate rate(const CircuitState& y, const Components& u, const Number& w) const noexcept {
    const Components i = current(y);
    const Components slip = reluctance(dot(y.rotor, y.rotor)) * y.rotor - i;  // rotor current, reversed
    return {u - stator_resistance_ * i,
            turned(y.rotor, w) - rotor_resistance_ * slip,
            u * i,
            i * i,
            slip * slip,
            torque_factor_ * cross(y.rotor, i)};
  }

 protected:
  /// What the rotor flux changes by because the rotor turns.
  Components turned(const Components& flux, const Number& w) const noexcept {
    return both(w) * signed_pole_pairs_ * swapped(flux);
  }
  /// 1/L_M at the square of the rotor flux (1/H).
  Number reluctance(const Number& square) const noexcept {
    return reluctance_ * (1.0 + saturation_ * square * square * square);
  }

  CircuitState state_{};
  Components signed_pole_pairs_{};  // -p, p
  Number pole_pairs_ = 0.0;
  Number torque_factor_ = 0.0;
  Number inverse_leakage_ = 0.0;
  Number reluctance_ = 0.0;  // 1/L_M without saturation
  Number saturation_ = 0.0;  // 1/(V·s)^6
  Number stator_resistance_ = 0.0;
  Number rotor_resistance_ = 0.0;
};

}  // namespace motor
