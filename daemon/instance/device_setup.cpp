#include "daemon/instance/device_setup.hpp"

#include <memory>
#include <utility>
#include <vector>

#include "cia402/face.hpp"
#include "daemon/instance/memory/unit_memory.hpp"
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

drive::AxisConfiguration drive_of(const AxisConfiguration& axis) {
  return {.machine = axis.machine,
          .load = axis.load,
          .kind = axis.kind,
          .inverter = axis.inverter,
          .deviation = axis.deviation,
          .setpoint_channel = axis.setpoint_channel,
          .mechanics = axis.mechanics,
          .switches = axis.switches,
          .positioner = axis.positioner};
}

device::AxisSetup setup_of(const AxisConfiguration& axis) {
  return {.drive = drive_of(axis), .presets = presets_of(axis.parameters)};
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

namespace {

cia402::Configuration cia402_configuration(const Configuration& configuration, const bus::Port& port) {
  cia402::Configuration result{.node_id = static_cast<std::uint8_t>(configuration.node_id),
                               .serial = configuration.cia402->serial,
                               .axes = {},
                               .supply = configuration.supply,
                               .remote_frames = port.carries_remote_frames()};
  for (const AxisConfiguration& axis : configuration.axes) {
    result.axes.push_back({.drive = drive_of(axis),
                           .switches = axis.cia402.switches,
                           .homing_distance = axis.cia402.homing_distance,
                           .missed_setpoints = configuration.cia402->missed_setpoints});
    result.axes.back().drive.setpoint_channel = false;
  }
  return result;
}

}  // namespace

DevicePlan device_plan(const Configuration& configuration, const DeviceSite& site,
                       const std::filesystem::path& folder, const Log& log) {
  if (configuration.cia402) {
    cia402::Configuration device = cia402_configuration(configuration, site.port);
    unit::Configuration unit = cia402::unit_configuration(device);
    return {std::move(unit), [device = std::move(device), site](unit::Runner& runner) {
              return std::make_unique<cia402::Face>(device, runner, site.sink, site.listener, site.listener);
            }};
  }
  device::Configuration device = device_configuration(configuration, site.port, folder, log);
  unit::Configuration unit = device::unit_configuration(device);
  return {std::move(unit), [device = std::move(device), site](unit::Runner& runner) {
            return std::make_unique<device::CanopenFace>(device, runner, site.sink, site.listener);
          }};
}

}  // namespace axisd
