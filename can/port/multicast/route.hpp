#pragma once

#include <string>

#include "can/port/socket_address.hpp"

namespace bus {

/// Name of the interface over which the kernel sends to @p destination; empty with errno set if there is no route.
[[nodiscard]] std::string interface_towards(const SocketAddress& destination);

}  // namespace bus
