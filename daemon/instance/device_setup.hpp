#pragma once

#include <filesystem>

#include "can/port/port.hpp"
#include "daemon/configuration/configuration.hpp"
#include "device/device.hpp"
#include "service/log.hpp"

namespace axisd {

/// What @p configuration says of the unit on @p port. Where the address switch stands at 0, its node-ID is read
/// from what is saved in @p folder.
device::Configuration device_configuration(const Configuration& configuration, const bus::Port& port,
                                           const std::filesystem::path& folder, const Log& log);

/// What a device is made of: its drives, and the face to its bus.
struct DevicePlan {
  unit::Configuration unit;
  device::Device::MakeFace make_face;
};

/// Where a device is put in place.
struct DeviceSite {
  const bus::Port& port;
  canopen::FrameSink& sink;
  device::Listener& listener;
};

/// What @p configuration says of the device on the bus of @p site. Where the address switch of a unit stands at 0,
/// its node-ID is read from what is saved in @p folder.
DevicePlan device_plan(const Configuration& configuration, const DeviceSite& site,
                       const std::filesystem::path& folder, const Log& log);

}  // namespace axisd
