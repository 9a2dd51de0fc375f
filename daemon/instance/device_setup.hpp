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

}  // namespace axisd
