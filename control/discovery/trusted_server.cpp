#include "control/discovery/trusted_server.hpp"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/time.h>

#include "control/discovery/server_trust.hpp"
#include "control/socket_name.hpp"

namespace control {

void set_patience(const os::Descriptor& socket, std::chrono::seconds patience) noexcept {
  const timeval time{patience.count(), 0};
  ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time);
  ::setsockopt(socket.get(), SOL_SOCKET, SO_SNDTIMEO, &time, sizeof time);
}

tl::expected<os::Descriptor, std::string> connect_to(const std::string& path, std::chrono::seconds patience) {
  const auto address = socket_address(path);
  if (!address) return tl::unexpected{address.error()};
  const bool waits = patience.count() != 0;
  os::Descriptor socket{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | (waits ? 0 : SOCK_NONBLOCK), 0)};
  if (socket && waits) set_patience(socket, patience);
  // A Unix socket is connected at once, or its queue is full: who does not wait then tries again later.
  if (!socket || ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0)
    return tl::unexpected{
        fmt::format("{}: no daemon answers here ({})", path, std::generic_category().message(errno))};
  if (auto trusted = check_server(socket.get(), path); !trusted) return tl::unexpected{std::move(trusted.error())};
  return socket;
}

}  // namespace control
