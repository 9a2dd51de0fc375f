#pragma once

#include <cstdint>

namespace cia402 {

/// Position units are those of 607Ah and 6064h (608Fh, 6091h, 6092h), as numbers with a fraction; velocities and
/// accelerations are theirs by s and s². Torques are N·m at the motor shaft.

/// What the control is led by.
enum class Lead : std::uint8_t {
  Position,  ///< position control, with the velocity as feed-forward
  Velocity,  ///< speed control
  Torque,    ///< torque control, up to the speed cap
};

/// Where the demand is.
struct Motion {
  double position = 0.0;  ///< position units, before 607Bh wraps it
  double velocity = 0.0;  ///< position units/s
  double torque = 0.0;    ///< N·m
};

/// What a mode asks for at the end of a cycle of 1 ms.
struct Demand {
  Lead lead = Lead::Position;
  Motion motion{};
  double velocity_offset = 0.0;  ///< feed-forward beside the slope of the position (60B1h; position units/s)
  double torque_offset = 0.0;    ///< feed-forward (60B2h; N·m)
  bool is_limited = false;       ///< by the speed cap or a position limit (6041h bit 11)
};

/// What the axis does, as its encoder tells it.
struct Actual {
  double position = 0.0;  ///< position units, before 607Bh wraps it
  double velocity = 0.0;  ///< position units/s
  double torque = 0.0;    ///< N·m
};

/// The bits of the statusword that a mode owns (6041h 10, 12, 13).
struct ModeBits {
  bool bit_10 = false;
  bool bit_12 = false;
  bool bit_13 = false;

  friend bool operator==(const ModeBits&, const ModeBits&) = default;
};

/// Length of a cycle of the motion (s).
inline constexpr double kCycle = 1e-3;

}  // namespace cia402
