#pragma once

#include <string>

#include "daemon/configuration/settings/modbus_settings.hpp"
#include "os/descriptor.hpp"

namespace axisd {

/// A socket that listens for connections of TCP.
struct Listener {
  os::Descriptor descriptor;
  std::string place;  ///< address and port: "127.0.0.1:502", "[::1]:502"
};

/// Listens where @p settings say. Throws InstanceError, whose one line says what was wrong, where, and what was
/// expected.
Listener listen_at(const ModbusSettings& settings);

/// A connection that waits at @p listener; none if there is none. errno says why.
os::Descriptor accept_at(const os::Descriptor& listener) noexcept;

}  // namespace axisd
