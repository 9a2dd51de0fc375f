#include "gateway/units/reach.hpp"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>
#include <sys/socket.h>

#include "control/discovery/server_trust.hpp"
#include "control/discovery/socket_files.hpp"
#include "control/socket_name.hpp"

namespace gateway {

std::vector<std::string> SocketReach::places() const {
  if (!paths_.empty()) return paths_;
  std::vector<std::string> found;
  for (const control::SocketFile& file : control::socket_files()) found.push_back(file.path);
  return found;
}

tl::expected<os::Descriptor, std::string> SocketReach::connect(const std::string& path) {
  const auto address = control::socket_address(path);
  if (!address) return tl::unexpected{address.error()};
  os::Descriptor socket{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  // A Unix socket is connected at once, or its queue is full: then it is tried again later.
  if (!socket || ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0)
    return tl::unexpected{
        fmt::format("{}: no daemon answers here ({})", path, std::generic_category().message(errno))};
  if (const auto trusted = control::check_server(socket.get(), path); !trusted)
    return tl::unexpected{trusted.error()};
  return socket;
}

}  // namespace gateway
