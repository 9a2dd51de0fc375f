#pragma once

#include <cstdint>

#include "drive/axis/axis.hpp"

namespace cia402 {

/// Increments of 608Fh in a revolution of the motor, whatever encoder there is.
inline constexpr std::uint32_t kIncrements = 65536;

/// What the drive behind an axis does, between two cycles.
struct DriveState {
  std::int64_t increments = 0;  ///< of the motor since power-on, whole ones below the place
  double fraction = 0.0;        ///< of an increment above them, 0..1
  double load_place = 0.0;      ///< load revolutions from the place at power-on
  double speed = 0.0;           ///< rad/s
  double torque = 0.0;          ///< N·m
  double torque_demand = 0.0;   ///< N·m
  double current = 0.0;         ///< A rms, with the sign of the torque
  double dc_voltage = 0.0;      ///< V
  bool has_pulses = false;
  bool follows = false;      ///< setpoints: the pulses are on, the machine is magnetised, the brake is open
  bool has_voltage = false;  ///< the DC link is charged
  bool has_alarm = false;
  bool at_torque_limit = false;
};

/// The state of @p axis.
DriveState state_of(const drive::Axis& axis) noexcept;

}  // namespace cia402
