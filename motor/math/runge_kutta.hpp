#pragma once

namespace motor {

/// Sum of four stage values with the weights of the classical Runge-Kutta method, 1, 2, 2 and 1.
template <class Value>
constexpr Value stage_sum(const Value& k1, const Value& k2, const Value& k3, const Value& k4) noexcept {
  const Value middle = k2 + k3;
  return (k1 + k4) + (middle + middle);
}

/// What stage_sum() is to be multiplied by to give the change in a step of @p h (s).
template <class Number>
constexpr Number stage_weight(const Number& h) noexcept {
  return h * (1.0 / 6.0);
}

/// Weighted sums of the rates of all stages: of states and of energies.
template <class CircuitRate, class ShaftRate>
struct SummedRates {
  CircuitRate circuit;
  ShaftRate shaft;

  template <class Mask>
  friend SummedRates select(const Mask& condition, const SummedRates& a, const SummedRates& b) noexcept {
    return {select(condition, a.circuit, b.circuit), select(condition, a.shaft, b.shaft)};
  }
};

/// One classical Runge-Kutta step of @p h (s) of a circuit and the shaft that its torque turns, all states
/// coupled. The circuit sees where the shaft is; the shaft sees the torque of the circuit in the same stage.
template <class Circuit, class Shaft, class Number>
[[gnu::always_inline]] inline SummedRates<typename Circuit::Rate, typename Shaft::Rate> runge_kutta(
    Circuit& circuit, const Shaft& shaft, const Number& h) noexcept {
  const Number half = 0.5 * h;
  const auto y = circuit.state();
  const auto z = shaft.state();

  const auto c1 = circuit.template rate<0>(y, z.angle, z.speed);
  const auto m1 = shaft.rate(z, c1.torque, Number{0.0});
  const auto z2 = z.moved(m1, half);
  const auto c2 = circuit.template rate<1>(y.moved(c1, half), z2.angle, z2.speed);
  const auto m2 = shaft.rate(z2, c2.torque, half);
  const auto z3 = z.moved(m2, half);
  const auto c3 = circuit.template rate<2>(y.moved(c2, half), z3.angle, z3.speed);
  const auto m3 = shaft.rate(z3, c3.torque, half);
  const auto z4 = z.moved(m3, h);
  const auto c4 = circuit.template rate<3>(y.moved(c3, h), z4.angle, z4.speed);
  const auto m4 = shaft.rate(z4, c4.torque, h);

  return {Circuit::Rate::summed(c1, c2, c3, c4), Shaft::Rate::summed(m1, m2, m3, m4)};
}

}  // namespace motor
