#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <tl/expected.hpp>

namespace bus {

/// An interface of the kernel's CAN, for example "vcan0".
struct KernelInterface {
  std::string name;  ///< 1 to 15 characters

  friend bool operator==(const KernelInterface&, const KernelInterface&) = default;
};

/// A bus in user space that a hub serves at a Unix socket (docs/explanation/user-space-bus.md).
struct UserBusPath {
  std::string path;  ///< absolute, at most 107 bytes

  friend bool operator==(const UserBusPath&, const UserBusPath&) = default;
};

/// A bus of UDP datagrams, as python-can's udp_multicast has it.
struct MulticastGroup {
  std::string group;       ///< IPv4 or IPv6, in its shortest form
  std::uint16_t port = 0;  ///< 1..65535
  std::string interface;   ///< empty: the one of the route to the group

  friend bool operator==(const MulticastGroup&, const MulticastGroup&) = default;
};

/// A bus behind a server that speaks socketcand's protocol.
struct SocketcandServer {
  std::string host;        ///< name or address, an IPv6 address without its brackets
  std::uint16_t port = 0;  ///< 1..65535
  std::string bus;         ///< the server's name for the bus

  friend bool operator==(const SocketcandServer&, const SocketcandServer&) = default;
};

/// What an Address leads to.
using Place = std::variant<KernelInterface, UserBusPath, MulticastGroup, SocketcandServer>;

/// Where a bus is: what `--interface` and the configuration say.
struct Address {
  /// As a user writes it; "unix:" has its path in it.
  std::string text;
  Place place;

  friend bool operator==(const Address&, const Address&) = default;
};

/// Reads `NAME`, `unix:PATH` (`unix:` alone is the default bus of this user, a relative path begins at the current
/// folder), `udp-multicast://GROUP:PORT[?interface=NAME]` (an IPv6 group in brackets) or
/// `socketcand://HOST:PORT/NAME`. The error says what was expected: "a port 1 to 65535 behind the group".
[[nodiscard]] tl::expected<Address, std::string> parse_address(std::string_view text);

/// A name for files and sockets: the interface itself, or for a URL what it is, a part to read, and eight
/// hexadecimal digits that tell it from others, such as "unix-can-bus-1a2b3c4d". At most 40 characters, without
/// slash, colon or space; the same for every way to write the same address.
[[nodiscard]] std::string label(const Address& address);

/// The IPv4 or IPv6 address @p text in its shortest form; nothing if it is none.
[[nodiscard]] std::optional<std::string> normal_ip_address(const std::string& text);

}  // namespace bus
