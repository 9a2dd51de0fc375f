#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "drive/drive_unit.hpp"
#include "unit/configuration.hpp"

namespace device {

using unit::Delivery;
using unit::ParameterPreset;

/// One axis of the unit.
struct AxisSetup {
  drive::AxisConfiguration drive{};
  std::vector<ParameterPreset> presets{};  ///< existing, writable and within their limits
  Delivery delivery{};                     ///< below them; likewise
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
[[nodiscard]] inline unit::Configuration unit_configuration(const Configuration& configuration) {
  drive::UnitConfiguration drive{.axes = {},
                                 .node_id = configuration.node_id,
                                 .address_switch_off = configuration.address_switch_off,
                                 .supply = configuration.supply,
                                 .infeed = configuration.infeed};
  unit::Configuration unit{.drive = std::move(drive),
                           .presets = configuration.presets,
                           .infeed_presets = configuration.infeed_presets,
                           .axis_deliveries = {},
                           .axis_presets = {}};
  unit.drive.axes.clear();
  for (const AxisSetup& axis : configuration.axes) {
    unit.drive.axes.push_back(axis.drive);
    unit.axis_deliveries.push_back(axis.delivery);
    unit.axis_presets.push_back(axis.presets);
  }
  return unit;
}

}  // namespace device
