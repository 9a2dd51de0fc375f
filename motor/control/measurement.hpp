#pragma once

#include "motor/math/space_vector.hpp"

namespace motor {

/// What the control learns at the start of a period; vectors in the stator frame.
template <class Number>
struct MeasurementOf {
  SpaceVectorOf<Number> current{};        ///< (A)
  SpaceVectorOf<Number> voltage{};        ///< what the inverter gave in the period that ends now (V)
  SpaceVectorOf<Number> rotor{1.0, 0.0};  ///< direction of the electrical rotor angle, from the encoder
  Number speed = 0.0;                     ///< from the encoder (rad/s)
  Number dc_voltage = 0.0;                ///< (V)
};
using Measurement = MeasurementOf<double>;

}  // namespace motor
