#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats/server.hpp"

namespace farm {

/// A farm: hosts with units, and the NATS server over which they are reached.
struct FarmUrl {
  nats::Server server;
  std::string host;  ///< name or address of the server, an IPv6 address without its brackets
  std::string name;  ///< of the farm: 1 to 32 letters, digits, '-' and '_'
};

/// Reads `nats://HOST[:PORT]/FARM` or `tls://HOST[:PORT]/FARM`; the port is 4222 if none is given. The error says
/// what was expected.
[[nodiscard]] tl::expected<FarmUrl, std::string> parse_farm_url(std::string_view text);

}  // namespace farm
