#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "cia402/drive/drive_link.hpp"
#include "cia402/inputs/travel_switches.hpp"
#include "drive/base/axis_configuration.hpp"
#include "unit/configuration.hpp"

namespace cia402 {

/// One axis of the device.
struct AxisSetup {
  drive::AxisConfiguration drive{};
  TravelSwitches switches{};           ///< beside the way of the load
  double homing_distance = 200.0;      ///< longest way of a homing without an event (load revolutions), positive
  std::uint32_t missed_setpoints = 3;  ///< in a row, which are a fault (8700h); 0: never
};

/// What the device is made of.
struct Configuration {
  std::uint8_t node_id = 2;                  ///< 1..127, or canopen::kNoNodeId: unconfigured (CiA 305)
  std::uint32_t serial = 1;                  ///< 1018h:4
  std::vector<AxisSetup> axes{AxisSetup{}};  ///< 1..drive::kMostAxes
  motor::SupplyData supply{};                ///< of the DC link that feeds all axes
  bool remote_frames = true;                 ///< false: the bus carries none, so there is no life guarding
};

/// What the drives behind it are made of.
[[nodiscard]] inline unit::Configuration unit_configuration(const Configuration& configuration) {
  unit::Configuration unit{.drive = {.axes = {}, .node_id = configuration.node_id, .supply = configuration.supply},
                           .presets = control_unit_presets()};
  for (const AxisSetup& axis : configuration.axes) {
    unit.drive.axes.push_back(axis.drive);
    unit.axis_deliveries.emplace_back();
    unit.axis_presets.push_back(drive_presets());
  }
  return unit;
}

}  // namespace cia402
