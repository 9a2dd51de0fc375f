#pragma once

#include <cstddef>

#include "motor/math/pair.hpp"
#include "motor/math/runge_kutta.hpp"

namespace motor {

/// Permanent-magnet synchronous machine in rotor coordinates. The flux linkages derive from one co-energy,
/// W' = L_d i_d²/2 + psi_f (1 - s(i_q)) i_d + L_q i_q²/2, so that saturation neither makes nor loses energy.
template <class Number>
class SynchronousEquations {
 public:
  using Components = PairOf<Number>;
  struct Rate;
  /// Current of the rotor frame: d, q (A).
  struct CircuitState {
    Components current{};

    CircuitState moved(const Rate& rate, const Number& h) const noexcept { return {current + h * rate.current}; }
  };
  /// Change of the current (A/s), and what the energies and the torque are made of.
  struct Rate {
    Components current;
    Components power;    ///< by components u·i, 2/3 of the electrical power (W)
    Components heating;  ///< by components i² (A²)
    Number torque;       ///< (N·m)

    static Rate summed(const Rate& a, const Rate& b, const Rate& c, const Rate& d) noexcept {
      return {stage_sum(a.current, b.current, c.current, d.current), stage_sum(a.power, b.power, c.power, d.power),
              stage_sum(a.heating, b.heating, c.heating, d.heating),
              stage_sum(a.torque, b.torque, c.torque, d.torque)};
    }
    friend Rate select(const Condition<Number>& condition, const Rate& a, const Rate& b) noexcept {
      return {motor::select(condition, a.current, b.current), motor::select(condition, a.power, b.power),
              motor::select(condition, a.heating, b.heating), motor::select(condition, a.torque, b.torque)};
    }
  };

  /// Numbers that a step changes; they come first.
  static constexpr std::size_t kChanging = 2;
  /// Its voltages and currents are those of the rotor frame.
  static constexpr bool kTurnsWithRotor = true;
  /// Its saturation begins with a bend (see is_wide()).
  static constexpr bool kHasBend = true;

  const CircuitState& state() const noexcept { return state_; }
  void set_state(const CircuitState& state) noexcept { state_ = state; }
  Number pole_pairs() const noexcept { return pole_pairs_; }
  /// Copper losses (J) of a step with the summed rates @p sum, @p weight from stage_weight().
  Number losses(const Rate& sum, const Number& weight) const noexcept {
    return 1.5 * weight * motor::sum(resistance_ * sum.heating);
  }
  static Components current(const CircuitState& y) noexcept { return y.current; }
  /// Flux linkages of the rotor frame (V·s).
  Components flux(const CircuitState& y) const noexcept {
    const Components linear = inductance_ * y.current + magnets_;
    const Condition<Number> saturated = is_saturated(y);
    if (!any(saturated)) return linear;
    const Saturation s = saturation(y.current[1]);
    return select(saturated, linear - Components{s.loss, s.slope * y.current[0]}, linear);
  }
  /// Torque in the air gap (N·m).
  Number torque() const noexcept { return torque_factor_ * cross(flux(state_), state_.current); }
  /// Flux linkage of the d axis (V·s).
  Number main_flux() const noexcept { return flux(state_)[0]; }
  /// Whether saturation counts for the current @p y.
  Condition<Number> is_saturated(const CircuitState& y) const noexcept {
    return y.current[1] * y.current[1] > saturation_start_;
  }
  /// Whether a step with the summed rates @p sum, @p weight from stage_weight(), is too wide for the bend of
  /// saturation.
  Condition<Number> is_wide(const Rate& sum, const Number& weight) const noexcept {
    const Number change = weight * sum.current[1];
    const Condition<Number> wide = change * change > kWidestChange * saturation_start_;
    if (!any(wide)) [[likely]]
      return wide;
    return wide && (is_saturated(state_) || is_saturated(state_.moved(sum, weight)));
  }
  /// Rates under the voltage @p u of the rotor frame (V) at the mechanical speed @p w (rad/s).
  template <bool Saturated = true>
  Rate rate(const CircuitState& y, const Components& u, const Number& w) const noexcept {
    if constexpr (Saturated) return saturated_rate(y, u, w);
    // The voltage equation divided by the inductances: all that does not depend on the state is in the factors.
    const Components i = y.current;
    return {(inverse_inductance_ * u - damping_ * i) + both(w) * (exchange_ * swapped(i) + induction_), u * i,
            i * i, i[1] * (magnet_torque_ + reluctance_torque_ * i[0])};
  }

 protected:
  /// What saturation takes: from the flux of the magnets (V·s), its derivatives by i_q (V·s/A, V·s/A²).
  struct Saturation {
    Number loss = 0.0;
    Number slope = 0.0;
    Number curvature = 0.0;
  };
  Saturation saturation(const Number& i_q) const noexcept;
  /// Area below the first @p x of the smooth step 3x² - 2x³, 0..1.
  static Number bent(const Number& x) noexcept { return x * x * x * (1.0 - 0.5 * x); }
  Rate saturated_rate(const CircuitState& y, const Components& u, const Number& w) const noexcept;

  /// Least share of L_q that saturation leaves.
  static constexpr double kLeastInductance = 0.25;
  /// Square of the most that i_q changes in a step while saturation counts, as a share of that where it starts:
  /// half of the bend.
  static constexpr double kWidestChange = 0.13;

  CircuitState state_{};
  Components inductance_{};          // d, q
  Components inverse_inductance_{};  // d, q
  Components magnets_{};             // flux linkage d, and none of q
  Components signed_pole_pairs_{};   // p, -p
  Components resistance_{};          // of one phase, twice
  Components damping_{};             // R/L (1/s)
  Components exchange_{};            // p L_q/L_d, -p L_d/L_q
  Components induction_{};           // what the magnets induce: 0, -p psi_f/L_q (A)
  Number pole_pairs_ = 0.0;
  Number torque_factor_ = 0.0;
  Number magnet_torque_ = 0.0;      // of i_q (N·m/A)
  Number reluctance_torque_ = 0.0;  // of i_d·i_q (N·m/A²)
  Number saturation_start_ = 0.0;   // i_q² above which the flux falls (A²)
  Number saturation_knee_ = 0.0;    // i_q² from which it falls with i_q² (A²)
  Number saturation_end_ = 0.0;     // i_q² of the maximum current (A²)
  Number saturation_gain_ = 0.0;    // share of the flux lost for each A²
};

template <class Number>
auto SynchronousEquations<Number>::saturation(const Number& i_q) const noexcept -> Saturation {
  const Number square = i_q * i_q;
  const Condition<Number> none = square <= saturation_start_;
  if (all(none)) return {};
  // Share of the flux over i_q²: a bend, a line, and a bend that ends level, because no more can be lost than all.
  // The slope of a bend is a smooth step, so that no inductance jumps: a jump within an integration step costs
  // energy.
  const Number width = saturation_knee_ - saturation_start_;
  const Number line = 0.5 * (saturation_start_ + saturation_knee_);
  Number share = square - line;
  Number slope = 1.0;
  Number curvature = 0.0;
  if (const Condition<Number> bend = square < saturation_knee_; any(bend)) {
    const Number x = (square - saturation_start_) / width;
    share = select<Number>(bend, width * bent(x), share);
    slope = select<Number>(bend, x * x * (3.0 - 2.0 * x), slope);
    curvature = select<Number>(bend, 6.0 * x * (1.0 - x) / width, curvature);
  }
  if (const Condition<Number> end = square > saturation_end_; any(end)) {
    const Number tail = saturation_end_ - line;
    const auto x = minimum<Number>((square - saturation_end_) / tail, 1.0);
    share = select<Number>(end, tail * (1.0 + x - bent(x)), share);
    slope = select<Number>(end, 1.0 - x * x * (3.0 - 2.0 * x), slope);
    curvature = select<Number>(end, -6.0 * x * (1.0 - x) / tail, curvature);
  }
  const Number gain = saturation_gain_ * magnets_[0];
  return {select<Number>(none, 0.0, gain * share), select<Number>(none, 0.0, 2.0 * gain * slope * i_q),
          select<Number>(none, 0.0, gain * (4.0 * curvature * square + 2.0 * slope))};
}

template <class Number>
auto SynchronousEquations<Number>::saturated_rate(const CircuitState& y, const Components& u,
                                                  const Number& w) const noexcept -> Rate {
  const Components i = y.current;
  const Saturation s = saturation(i[1]);
  const Components psi = inductance_ * i + magnets_ - Components{s.loss, s.slope * i[0]};
  const Components rest = u - resistance_ * i + both(w) * signed_pole_pairs_ * swapped(psi);
  const Number l_d = inductance_[0];
  const Number l_q = maximum<Number>(inductance_[1] - s.curvature * i[0], kLeastInductance * inductance_[1]);
  const Number scale = 1.0 / (l_d * l_q - s.slope * s.slope);
  return {scale * Components{l_q * rest[0] + s.slope * rest[1], s.slope * rest[0] + l_d * rest[1]}, u * i, i * i,
          torque_factor_ * cross(psi, i)};
}

}  // namespace motor
