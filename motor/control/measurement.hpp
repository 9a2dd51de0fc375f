#pragma once

#include "motor/math/space_vector.hpp"

namespace motor {

/// What the control learns at the start of a period; vectors in the stator frame.
struct Measurement {
  SpaceVector current{};        ///< (A)
  SpaceVector voltage{};        ///< what the inverter gave in the period that ends now (V)
  SpaceVector rotor{1.0, 0.0};  ///< direction of the electrical rotor angle, from the encoder
  double speed = 0.0;           ///< from the encoder (rad/s)
  double dc_voltage = 0.0;      ///< (V)
};

}  // namespace motor
