#include "can/port/multicast/multicast_socket.hpp"

#include <cerrno>
#include <cstring>

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>

#include "can/port/socket_option.hpp"

namespace bus::multicast {

namespace {

constexpr int kOneHop = 1;
constexpr int kOn = 1;
constexpr int kOff = 0;

/// @p address as a Structure of the kernel.
template <class Structure>
Structure as(const SocketAddress& address) noexcept {
  Structure structure{};
  std::memcpy(&structure, &address.storage, sizeof structure);
  return structure;
}

bool is_six(const SocketAddress& address) noexcept {
  return address.storage.ss_family == AF_INET6;
}

bool same_host(const SocketAddress& a, const SocketAddress& b) noexcept {
  if (a.storage.ss_family != b.storage.ss_family) return false;
  if (!is_six(a)) return as<sockaddr_in>(a).sin_addr.s_addr == as<sockaddr_in>(b).sin_addr.s_addr;
  const in6_addr left = as<sockaddr_in6>(a).sin6_addr;
  const in6_addr right = as<sockaddr_in6>(b).sin6_addr;
  return std::memcmp(&left, &right, sizeof left) == 0;
}

os::Descriptor open_datagram_socket(int family) noexcept {
  return os::Descriptor{::socket(family, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
}

bool connect_to(const os::Descriptor& socket, const SocketAddress& group, SocketAddress& source) noexcept {
  return ::connect(socket.get(), group.get(), group.length) == 0 &&
         ::getsockname(socket.get(), source.get(), &source.length) == 0;
}

bool join(const os::Descriptor& socket, const SocketAddress& group, unsigned index) noexcept {
  if (is_six(group)) {
    const ipv6_mreq request{as<sockaddr_in6>(group).sin6_addr, index};
    return set_option(socket, IPPROTO_IPV6, IPV6_ADD_MEMBERSHIP, request);
  }
  const ip_mreqn request{as<sockaddr_in>(group).sin_addr, {}, static_cast<int>(index)};
  return set_option(socket, IPPROTO_IP, IP_ADD_MEMBERSHIP, request);
}

/// Also to the other programs of this machine, and not beyond the next router.
bool prepare_to_send(const os::Descriptor& socket, const SocketAddress& group, unsigned index) noexcept {
  if (is_six(group))
    return set_option(socket, IPPROTO_IPV6, IPV6_MULTICAST_HOPS, kOneHop) &&
           set_option(socket, IPPROTO_IPV6, IPV6_MULTICAST_LOOP, kOn) &&
           set_option(socket, IPPROTO_IPV6, IPV6_MULTICAST_IF, index);
  const ip_mreqn interface { {}, {}, static_cast<int>(index) };
  return set_option(socket, IPPROTO_IP, IP_MULTICAST_TTL, kOneHop) &&
         set_option(socket, IPPROTO_IP, IP_MULTICAST_LOOP, kOn) &&
         set_option(socket, IPPROTO_IP, IP_MULTICAST_IF, interface);
}

/// Bound to the group, so that no other one of the same port is heard.
bool prepare_to_receive(const os::Descriptor& socket, const SocketAddress& group, unsigned index) noexcept {
  const bool this_group_only = is_six(group) || set_option(socket, IPPROTO_IP, IP_MULTICAST_ALL, kOff);
  return this_group_only && set_option(socket, SOL_SOCKET, SO_REUSEADDR, kOn) &&
         ::bind(socket.get(), group.get(), group.length) == 0 && join(socket, group, index);
}

}  // namespace

bool same(const SocketAddress& a, const SocketAddress& b) noexcept {
  // Both structures have the port in the same place.
  return same_host(a, b) && as<sockaddr_in>(a).sin_port == as<sockaddr_in>(b).sin_port;
}

SocketAddress address_of(const MulticastGroup& place, unsigned index) noexcept {
  SocketAddress address;
  if (place.group.find(':') != std::string::npos) {
    sockaddr_in6 six{};
    six.sin6_family = AF_INET6;
    six.sin6_port = htons(place.port);
    six.sin6_scope_id = index;
    ::inet_pton(AF_INET6, place.group.c_str(), &six.sin6_addr);
    std::memcpy(&address.storage, &six, sizeof six);
    address.length = sizeof six;
  } else {
    sockaddr_in four{};
    four.sin_family = AF_INET;
    four.sin_port = htons(place.port);
    ::inet_pton(AF_INET, place.group.c_str(), &four.sin_addr);
    std::memcpy(&address.storage, &four, sizeof four);
    address.length = sizeof four;
  }
  return address;
}

Sockets open_sockets(const MulticastGroup& place, const std::string& interface, int receive_buffer) noexcept {
  const unsigned index = ::if_nametoindex(interface.c_str());
  if (index == 0) return {};
  const SocketAddress group = address_of(place, index);
  Sockets sockets{
      open_datagram_socket(group.storage.ss_family), open_datagram_socket(group.storage.ss_family), {}};
  const bool opened = sockets.receiver && sockets.sender && prepare_to_receive(sockets.receiver, group, index) &&
                      prepare_to_send(sockets.sender, group, index) &&
                      connect_to(sockets.sender, group, sockets.source);
  if (opened) {
    ask_for_receive_buffer(sockets.receiver, receive_buffer);
    return sockets;
  }
  const int reason = errno;
  sockets = {};
  errno = reason;
  return sockets;
}

}  // namespace bus::multicast
