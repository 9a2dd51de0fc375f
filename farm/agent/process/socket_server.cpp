#include "farm/agent/process/socket_server.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include "can/userbus/join.hpp"
#include "control/discovery/trusted_server.hpp"

namespace farm::agent {
namespace {

/// The process at the other end of @p socket. While that is open the process has not ended, so its number is its
/// own.
tl::expected<ProcessHandle, std::string> peer_of(int socket, const std::string& path) {
  ucred peer{};
  socklen_t size = sizeof peer;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0)
    return tl::unexpected{fmt::format("{}: {}", path, std::strerror(errno))};
  auto process = find_process(peer.pid);
  pollfd end{socket, 0, 0};
  if (process && ::poll(&end, 1, 0) == 1 && (end.revents & POLLHUP) != 0)
    return tl::unexpected{fmt::format("{}: has ended", path)};
  return process;
}

}  // namespace

tl::expected<ProcessHandle, std::string> server_of_socket(const std::string& path) {
  return control::connect_to(path).and_then(
      [&](const os::Descriptor& socket) { return peer_of(socket.get(), path); });
}

tl::expected<ProcessHandle, std::string> server_of_bus(const std::string& path) {
  userbus::Path bus{};
  if (!userbus::copy_path(path.c_str(), bus))
    return tl::unexpected{fmt::format("{}: too long for a socket", path)};
  const userbus::Connected hub = userbus::connect_hub(bus, userbus::Kind::Port, SOCK_NONBLOCK | SOCK_CLOEXEC);
  const os::Descriptor member{hub.descriptor};
  if (!member) return tl::unexpected{fmt::format("{}: is not served", path)};
  return peer_of(member.get(), path);
}

}  // namespace farm::agent
