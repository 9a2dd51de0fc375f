#pragma once

#include <cstdint>

namespace drive {

/// Parameters that are 100 % of quantities in process data, in SI units.
struct ReferenceValues {
  double speed = 0.0;   ///< p2000 (rad/s)
  double torque = 0.0;  ///< p2003 (N·m)
};

/// What values on the bus are relative to, in SI units.
struct References {
  double speed = 0.0;                ///< p2000
  double torque = 0.0;               ///< p2003
  double rated_torque = 1.0;         ///< p0333
  double maximum_speed = 0.0;        ///< p1082
  std::uint32_t encoder_pulses = 0;  ///< of the motor encoder, a revolution
  unsigned encoder_fine_bits = 0;    ///< a pulse
};

}  // namespace drive
