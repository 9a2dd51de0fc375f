#pragma once

#include <cstdint>

namespace cia402 {

/// Modes of operation (6060h; CiA 402-2).
enum class Mode : std::int8_t {
  None = 0,
  ProfilePosition = 1,
  Velocity = 2,
  ProfileVelocity = 3,
  ProfileTorque = 4,
  Homing = 6,
  InterpolatedPosition = 7,
  CyclicSynchronousPosition = 8,
  CyclicSynchronousVelocity = 9,
  CyclicSynchronousTorque = 10,
};

}  // namespace cia402
