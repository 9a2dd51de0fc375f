#pragma once

#include "motor/math/number.hpp"

namespace motor {

/// Voltage controller of field weakening: how much stator flux the DC link leaves room for. A model of the machine
/// acts at once; what it does not know is found by the voltage that the current controllers ask for.
template <class Number>
class VoltageReserve {
 public:
  /// Longest voltage of a sine that @p dc_voltage (V) allows (V peak of a phase).
  static Number highest(const Number& dc_voltage) noexcept { return dc_voltage * kInverseRootThree; }
  void reset() noexcept { trim_ = 0.0; }
  /// One step of @p dt (s): @p demand is the square of the wanted voltage (V²), @p highest the longest one (V),
  /// @p drop what the resistance takes from it (V), @p weakening whether the flux is being weakened.
  void follow(double dt, const Number& demand, const Number& highest, const Number& drop,
              const Condition<Number>& weakening) noexcept {
    const Number goal = kShare * highest;
    const Number error = goal - sqrt(demand);
    // Without weakening the flux is not the voltage's, and the trim fades.
    trim_ =
        select<Number>(weakening, bounded<Number>(trim_ + kRate * dt * error, -kTrim * highest, kTrim * highest),
                       trim_ * (1.0 - kRate * dt));
    room_ = maximum<Number>(goal - drop + trim_, kLeast * highest);
  }
  /// Voltage that remains for the flux (V).
  Number room() const noexcept { return room_; }

 private:
  static constexpr double kInverseRootThree = 0.57735026918962576;
  static constexpr double kShare = 0.95;  // of the longest voltage; the rest is for the current controllers
  static constexpr double kRate = 60.0;   // 1/s
  static constexpr double kTrim = 0.25;   // of the longest voltage
  static constexpr double kLeast = 0.05;  // of the longest voltage

  Number trim_ = 0.0;  // V
  Number room_ = 0.0;  // V
};

}  // namespace motor
