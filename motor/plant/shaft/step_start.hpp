#pragma once

namespace motor {

/// Where and when a step begins.
struct StepStart {
  double time = 0.0;   ///< since power-on (s)
  double angle = 0.0;  ///< of the rotor since power-on (rad)
};

}  // namespace motor
