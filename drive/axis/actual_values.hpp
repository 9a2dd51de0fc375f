#pragma once

#include <cstdint>

#include "drive/sequence_control/state_machine.hpp"
#include "drive/speed_control/operating_mode.hpp"

namespace drive {

/// What the master sees of an axis after a cycle; measured speed and torques are means over the cycle.
struct ActualValues {
  std::uint16_t statusword = 0;
  double speed = 0.0;                 ///< r0063, from the encoder (rad/s)
  double speed_demand = 0.0;          ///< r1170, behind the ramp (rad/s)
  double torque_demand = 0.0;         ///< r0079 (N·m)
  double torque = 0.0;                ///< r0080 (N·m)
  std::int64_t encoder_counts = 0;    ///< increments since power-on
  std::int32_t encoder_position = 0;  ///< r0482, wraps at 32 bits
  State state = State::NotReadyToSwitchOn;
  std::int8_t mode = mode_code::kProfileVelocity;  ///< r8762, 6061h
  bool pulses_enabled = false;

  friend bool operator==(const ActualValues&, const ActualValues&) = default;
};

}  // namespace drive
