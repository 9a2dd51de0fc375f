#pragma once

#include <algorithm>

#include "motor/math/pair.hpp"
#include "motor/math/rotation.hpp"
#include "motor/math/space_vector.hpp"
#include "motor/plant/machine/induction_machine.hpp"
#include "motor/plant/machine/synchronous_machine.hpp"

namespace motor {

/// A machine under the voltage of an inverter, which is held in the stator frame. Not @p Saturated: the currents
/// are known to be too small for saturation.
template <class Machine, bool Saturated = true>
class HeldVoltage;

/// The stator frame turns back, seen from the rotor.
template <class Number, bool Saturated>
class HeldVoltage<SynchronousEquations<Number>, Saturated> {
 public:
  using Machine = SynchronousEquations<Number>;
  using CircuitState = typename Machine::CircuitState;
  using Rate = typename Machine::Rate;
  using Components = PairOf<Number>;

  /// @p voltage of the stator frame (V), with the rotor in @p direction at the start of the step.
  HeldVoltage(const Machine& machine, const SpaceVectorOf<Number>& voltage,
              const SpaceVectorOf<Number>& direction) noexcept
      : machine_{machine}, voltage_{turned_back<Number>(pair(voltage), direction.re, direction.im)} {}

  const CircuitState& state() const noexcept { return machine_.state(); }
  /// In stage @p Stage, with the rotor turned by @p angle (rad) since the start of the step.
  template <int Stage>
  Rate rate(const CircuitState& y, const Number& angle, const Number& speed) noexcept {
    return machine_.template rate<Saturated>(y, voltage<Stage>(machine_.pole_pairs() * angle), speed);
  }

 private:
  /// One series a step: the stages differ from the first half step, or from twice it, by the acceleration only.
  template <int Stage>
  Components voltage(const Number& angle) noexcept {
    if constexpr (Stage == 0) return voltage_;
    if constexpr (Stage == 1) {
      half_angle_ = angle;
      half_turn_ = small_rotation(angle);
      half_way_ = turned_back<Number>(voltage_, half_turn_[0], half_turn_[1]);
      return half_way_;
    }
    if constexpr (Stage == 2) return turned_back_a_little<Number>(half_way_, angle - half_angle_);
    return turned_back_a_little<Number>(turned_back<Number>(half_way_, half_turn_[0], half_turn_[1]),
                                        angle - 2.0 * half_angle_);
  }

  const Machine& machine_;
  Components voltage_;
  Components half_turn_{};
  Components half_way_{};
  Number half_angle_ = 0.0;
};

/// Constant in the frame of the machine.
template <class Number, bool Saturated>
class HeldVoltage<InductionEquations<Number>, Saturated> {
 public:
  using Machine = InductionEquations<Number>;
  using CircuitState = typename Machine::CircuitState;
  using Rate = typename Machine::Rate;

  HeldVoltage(const Machine& machine, const SpaceVectorOf<Number>& voltage, const SpaceVectorOf<Number>&) noexcept
      : machine_{machine}, voltage_{pair(voltage)} {}

  const CircuitState& state() const noexcept { return machine_.state(); }
  template <int Stage>
  Rate rate(const CircuitState& y, const Number&, const Number& speed) const noexcept {
    return machine_.rate(y, voltage_, speed);
  }

 private:
  const Machine& machine_;
  PairOf<Number> voltage_;
};

/// A machine behind an inverter without pulses: the diodes hold the voltage against the current.
template <class Machine>
class DiodeVoltage {
 public:
  using CircuitState = typename Machine::CircuitState;
  using Rate = typename Machine::Rate;

  /// Against @p limit, what the DC link can hold of a phase (V, peak). Below least_current() the diodes are taken
  /// for a resistance, the largest that a step of @p h (s) can follow.
  DiodeVoltage(const Machine& machine, double limit, double h) noexcept
      : machine_{machine}, limit_{limit}, least_current_{limit * h / (kFollowed * machine.least_inductance())} {}

  const CircuitState& state() const noexcept { return machine_.state(); }
  /// Current that a step cannot tell from none (A).
  double least_current() const noexcept { return least_current_; }
  template <int Stage>
  Rate rate(const CircuitState& y, double, double speed) const noexcept {
    const Pair i = machine_.current(y);
    const double amplitude = std::max({length(vector(i)), least_current_, kTinyCurrent});
    return machine_.rate(y, (-limit_ / amplitude) * i, speed);
  }

 private:
  static constexpr double kFollowed = 1.5;      // step times rate
  static constexpr double kTinyCurrent = 1e-9;  // A

  const Machine& machine_;
  double limit_;
  double least_current_;
};

/// A machine whose terminals carry no current.
template <class Machine>
class OpenTerminals {
 public:
  using CircuitState = typename Machine::CircuitState;
  using Rate = typename Machine::Rate;

  explicit OpenTerminals(const Machine& machine) noexcept : machine_{machine} {}

  const CircuitState& state() const noexcept { return machine_.state(); }
  template <int Stage>
  Rate rate(const CircuitState& y, double, double speed) const noexcept {
    return machine_.blocked_rate(y, speed);
  }

 private:
  const Machine& machine_;
};

}  // namespace motor
