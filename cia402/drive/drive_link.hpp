#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "drive/axis/axis.hpp"
#include "unit/configuration.hpp"

namespace cia402 {

/// How the sequence control of the drive is led.
enum class Power : std::uint8_t {
  Off,   ///< pulses off at once
  Stop,  ///< pulses off at standstill, when the holding brake has closed
  On,    ///< pulses on, setpoints enabled
};

/// What the drive behind an axis is to do in a cycle.
struct DriveCommand {
  Power power = Power::Off;
  bool torque_control = false;
  bool acknowledges = false;   ///< faults
  bool holds_brake = false;    ///< the holding brake stays closed, whatever the drive does
  double speed = 0.0;          ///< setpoint (rad/s)
  double torque = 0.0;         ///< setpoint of torque control (N·m)
  double torque_offset = 0.0;  ///< added to the setpoint that the speed controller gives (N·m)
  double upper_torque = 0.0;   ///< limit, not negative (N·m)
  double lower_torque = 0.0;   ///< limit, not positive (N·m)
};

/// Puts what an axis asks for into the process data of its drive, which is wired for that by drive_presets(). The
/// words are relative to the references p2000 and p2003.
class DriveLink {
 public:
  /// The drive @p axis outlives this.
  explicit DriveLink(drive::Axis& axis) noexcept : axis_{axis} {}
  /// Brings @p command to the next cycle of the drive. ON is an edge for that: after Off comes a cycle of Stop.
  void bring(const DriveCommand& command) noexcept;

 private:
  void set(std::size_t place, double share) noexcept;

  drive::Axis& axis_;
  Power last_ = Power::Off;
};

/// What a drive needs that a DriveLink leads: encoder control, and its inputs at the words of the process data.
std::vector<unit::ParameterPreset> drive_presets();
/// What its control unit needs: process data every 1 ms.
std::vector<unit::ParameterPreset> control_unit_presets();

}  // namespace cia402
