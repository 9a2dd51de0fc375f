#pragma once

#include "motor/plant/shaft/load_torque.hpp"

namespace motor {

/// Where and when a step begins.
template <class Number>
struct StepStartOf {
  TorqueLineOf<Number> profile{};  ///< of the load
  Number angle = 0.0;              ///< of the rotor since power-on (rad)
};
using StepStart = StepStartOf<double>;

}  // namespace motor
