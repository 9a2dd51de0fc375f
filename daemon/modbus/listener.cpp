#include "daemon/modbus/listener.hpp"

#include <cerrno>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include "daemon/base/instance_error.hpp"

namespace axisd {
namespace {

/// Ports below this one need a privilege.
constexpr std::uint16_t kFreePorts = 1024;
/// A client that is gone without a word is noticed after silence (s), questions (s apart), and so many of them.
constexpr int kSilence = 60, kQuestion = 10, kQuestions = 6;

std::string text_of(const std::string& address, unsigned port) {
  return address.find(':') == std::string::npos ? fmt::format("{}:{}", address, port)
                                                : fmt::format("[{}]:{}", address, port);
}

std::string expected_instead(const ModbusSettings& settings, int reason) {
  if (reason == EADDRINUSE) return "expected a port that nobody serves";
  if (reason == EADDRNOTAVAIL) return "expected an address of this machine";
  if (reason == EACCES && settings.port < kFreePorts)
    return fmt::format("expected a port from {} on, or CAP_NET_BIND_SERVICE", kFreePorts);
  return "expected a place to listen at";
}

InstanceError failure(const ModbusSettings& settings, int reason) {
  return InstanceError{fmt::format("modbus {}: {}: {}", text_of(settings.address, settings.port),
                                   std::strerror(reason), expected_instead(settings, reason))};
}

using AddressList = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

AddressList address_of(const ModbusSettings& settings) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(settings.address.c_str(), std::to_string(settings.port).c_str(), &hints, &found);
  if (error != 0) throw failure(settings, error == EAI_SYSTEM ? errno : EADDRNOTAVAIL);
  return AddressList{found, &::freeaddrinfo};
}

void set(int socket, int level, int name, int value) noexcept {
  ::setsockopt(socket, level, name, &value, sizeof value);  // what is refused is not vital
}

unsigned port_of(int socket) noexcept {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6*>(&address)->sin6_port
                                             : reinterpret_cast<const sockaddr_in*>(&address)->sin_port);
}

}  // namespace

Listener listen_at(const ModbusSettings& settings) {
  const AddressList address = address_of(settings);
  os::Descriptor socket{::socket(address->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  if (!socket) throw failure(settings, errno);
  set(socket.get(), SOL_SOCKET, SO_REUSEADDR, 1);
  const bool listens =
      ::bind(socket.get(), address->ai_addr, address->ai_addrlen) == 0 && ::listen(socket.get(), SOMAXCONN) == 0;
  if (!listens) throw failure(settings, errno);
  std::string place = text_of(settings.address, port_of(socket.get()));
  return {std::move(socket), std::move(place)};
}

os::Descriptor accept_at(const os::Descriptor& listener) noexcept {
  os::Descriptor socket{::accept4(listener.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK)};
  if (!socket) return socket;
  set(socket.get(), IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket.get(), SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket.get(), IPPROTO_TCP, TCP_KEEPIDLE, kSilence);
  set(socket.get(), IPPROTO_TCP, TCP_KEEPINTVL, kQuestion);
  set(socket.get(), IPPROTO_TCP, TCP_KEEPCNT, kQuestions);
  return socket;
}

}  // namespace axisd
