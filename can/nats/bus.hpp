#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats/server.hpp"

namespace nats {

/// A bus that hubs join over a server.
struct Bus {
  Server server;
  std::string host;  ///< name or address of the server, an IPv6 address without its brackets
  std::string port;
  std::string name;  ///< of the bus: letters, digits, '-' and '_'

  /// Name of its stream on the server.
  [[nodiscard]] std::string stream() const { return "CAN_" + name; }
  /// The subject that the stream keeps.
  [[nodiscard]] std::string subject() const { return "can." + name + ".wire"; }
  /// The subject of what is asked of its arbiter.
  [[nodiscard]] std::string requests() const { return "can." + name + ".tx"; }
  /// The key-value bucket with the lease of its arbiter.
  [[nodiscard]] std::string bucket() const { return "CAN_" + name; }
};

/// Reads `nats://HOST[:PORT]/NAME` or `tls://HOST[:PORT]/NAME`; the port is 4222 if none is given. The error says
/// what was expected.
[[nodiscard]] tl::expected<Bus, std::string> parse_bus(std::string_view url);

}  // namespace nats
