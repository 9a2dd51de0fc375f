#pragma once

#include <cstdint>
#include <vector>

#include "drive/drive_unit.hpp"

namespace device {

/// A value laid over a parameter of a new drive object, in the parameter's own unit.
struct ParameterPreset {
  std::uint16_t number;
  double value;
  std::uint8_t index = 0;
};

/// One axis of the unit.
struct AxisSetup {
  drive::AxisConfiguration drive{};
  std::vector<ParameterPreset> presets{};  ///< existing, writable and within their limits
};

/// What the unit is made of.
struct Configuration {
  std::uint8_t node_id = 2;                  ///< in force, 1..127
  bool address_switch_off = false;           ///< the switch stands at 0: node_id is p8620 as it was at power-on
  std::vector<AxisSetup> axes{AxisSetup{}};  ///< 1..drive::kMostAxes
  std::vector<ParameterPreset> presets{};    ///< of the control unit: saved parameters within their limits
  motor::SupplyData supply{};                ///< of the DC link that feeds all axes
  bool infeed = false;                       ///< the infeed is drive object 2, and the axes begin at 3
  std::vector<ParameterPreset> infeed_presets{};  ///< of it: writable and within their limits
  bool sdo_block = false;                         ///< SDO block transfer, which the real unit does not have
  bool fault_on_leaving_operational = true;       ///< F08701 when a master takes the node out of Operational
  bool remote_frames = true;                      ///< false: the bus carries none, so there is no life guarding
};

/// What the drive unit behind it is made of.
[[nodiscard]] inline drive::UnitConfiguration unit_configuration(const Configuration& configuration) {
  drive::UnitConfiguration unit{.axes = {},
                                .node_id = configuration.node_id,
                                .address_switch_off = configuration.address_switch_off,
                                .supply = configuration.supply,
                                .infeed = configuration.infeed};
  for (const AxisSetup& axis : configuration.axes) unit.axes.push_back(axis.drive);
  return unit;
}

}  // namespace device
