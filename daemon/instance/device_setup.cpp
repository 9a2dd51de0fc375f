#include "daemon/instance/device_setup.hpp"

#include <vector>

#include "daemon/instance/unit_memory.hpp"
#include "device/process_data/positioner_wiring.hpp"

namespace axisd {
namespace {

std::vector<device::ParameterPreset> presets_of(const std::vector<ParameterValue>& parameters) {
  std::vector<device::ParameterPreset> presets;
  presets.reserve(parameters.size());
  for (const ParameterValue& parameter : parameters)
    presets.push_back({parameter.number, parameter.value, parameter.index});
  return presets;
}

device::AxisSetup setup_of(const AxisConfiguration& axis) {
  return {.drive = {.machine = axis.machine,
                    .load = axis.load,
                    .kind = axis.kind,
                    .inverter = axis.inverter,
                    .deviation = axis.deviation,
                    .setpoint_channel = axis.setpoint_channel,
                    .mechanics = axis.mechanics,
                    .switches = axis.switches,
                    .positioner = axis.positioner},
          .presets = presets_of(axis.parameters)};
}

/// The ready wirings that @p axes of @p unit ask for.
void wire_positioners(const std::vector<AxisConfiguration>& axes, device::Configuration& unit) {
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].positioner_wiring)
      unit.axes[i].delivery =
          device::delivery_of(*axes[i].positioner_wiring, {.module = static_cast<std::uint8_t>(i),
                                                           .node_id = unit.node_id,
                                                           .kind = axes[i].kind,
                                                           .setpoint_channel = axes[i].setpoint_channel});
}

}  // namespace

device::Configuration device_configuration(const Configuration& configuration, const bus::Port& port,
                                           const std::filesystem::path& folder, const Log& log) {
  device::Configuration result{.node_id = static_cast<std::uint8_t>(configuration.node_id),
                               .address_switch_off = configuration.node_id == kAddressSwitchOff,
                               .axes = {},
                               .presets = presets_of(configuration.parameters),
                               .supply = configuration.supply,
                               .infeed = configuration.infeed.has_value(),
                               .infeed_presets = configuration.infeed
                                                     ? presets_of(configuration.infeed->parameters)
                                                     : std::vector<device::ParameterPreset>{},
                               .sdo_block = configuration.sdo_block,
                               .fault_on_leaving_operational = configuration.fault_on_leaving_operational,
                               .remote_frames = port.carries_remote_frames()};
  for (const AxisConfiguration& axis : configuration.axes) result.axes.push_back(setup_of(axis));
  if (result.address_switch_off)
    result.node_id = device::address_without_switch(result, UnitMemory::saved_parameters(folder, log));
  wire_positioners(configuration.axes, result);
  return result;
}

}  // namespace axisd
