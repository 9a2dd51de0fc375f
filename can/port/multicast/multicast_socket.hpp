#pragma once

#include <string>

#include "can/port/address.hpp"
#include "can/port/socket_address.hpp"
#include "os/descriptor.hpp"

namespace bus::multicast {

/// True if @p a and @p b are the same address and port.
[[nodiscard]] bool same(const SocketAddress& a, const SocketAddress& b) noexcept;

/// The address of @p place, of whose interface @p index is the number (0 = not known).
[[nodiscard]] SocketAddress address_of(const MulticastGroup& place, unsigned index) noexcept;

/// The two ends of a group on one interface.
struct Sockets {
  os::Descriptor receiver;  ///< a member of the group
  os::Descriptor sender;    ///< with a port of its own, by which its datagrams are recognised
  SocketAddress source;     ///< address and port of the sender
};

/// Opens both ends on the interface called @p interface; sends one hop far. On failure the receiver is none, and
/// errno is set.
[[nodiscard]] Sockets open_sockets(const MulticastGroup& place, const std::string& interface,
                                   int receive_buffer) noexcept;

}  // namespace bus::multicast
