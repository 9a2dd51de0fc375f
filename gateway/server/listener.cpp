#include "gateway/server/listener.hpp"

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace gateway {
namespace {

/// An address of either family.
struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t size = sizeof(sockaddr_storage);

  sockaddr* base() noexcept { return reinterpret_cast<sockaddr*>(&storage); }
};

SocketAddress socket_address_of(const Authority& address) {
  SocketAddress result;
  auto* const four = reinterpret_cast<sockaddr_in*>(&result.storage);
  auto* const six = reinterpret_cast<sockaddr_in6*>(&result.storage);
  if (::inet_pton(AF_INET, address.host.c_str(), &four->sin_addr) == 1) {
    four->sin_family = AF_INET;
    four->sin_port = htons(address.port.value_or(0));
    result.size = sizeof *four;
  } else if (::inet_pton(AF_INET6, address.host.c_str(), &six->sin6_addr) == 1) {
    six->sin6_family = AF_INET6;
    six->sin6_port = htons(address.port.value_or(0));
    result.size = sizeof *six;
  }
  return result;
}

std::uint16_t port_of(int socket) noexcept {
  SocketAddress address;
  if (::getsockname(socket, address.base(), &address.size) != 0) return 0;
  const auto* const four = reinterpret_cast<const sockaddr_in*>(&address.storage);
  const auto* const six = reinterpret_cast<const sockaddr_in6*>(&address.storage);
  return ntohs(address.storage.ss_family == AF_INET ? four->sin_port : six->sin6_port);
}

}  // namespace

os::Descriptor listen_at(Authority& address) {
  SocketAddress place = socket_address_of(address);
  os::Descriptor socket{::socket(place.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  const int yes = 1;
  const bool is_open = socket && ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) == 0 &&
                       (place.storage.ss_family != AF_INET6 ||
                        ::setsockopt(socket.get(), IPPROTO_IPV6, IPV6_V6ONLY, &yes, sizeof yes) == 0) &&
                       ::bind(socket.get(), place.base(), place.size) == 0 &&
                       ::listen(socket.get(), SOMAXCONN) == 0;
  if (!is_open)
    throw std::runtime_error{
        fmt::format("{}: cannot be served: {}", address.text(), std::generic_category().message(errno))};
  address.port = port_of(socket.get());
  return socket;
}

}  // namespace gateway
