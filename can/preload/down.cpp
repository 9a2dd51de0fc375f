#include "can/preload/down.hpp"

#include <cerrno>
#include <initializer_list>

#include <fcntl.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can/preload/next.hpp"

namespace preload {

namespace {

/// A datagram socket that is connected to itself: it is known by its name, and nobody can send to it. -1 on
/// failure.
int silent_socket(int flags) noexcept {
  const int descriptor = next().socket(AF_UNIX, SOCK_DGRAM | flags, 0);
  if (descriptor < 0) return -1;
  uint64_t number = 0;
  sockaddr_un name{};
  if (getrandom(&number, sizeof number, 0) == sizeof number) {
    const socklen_t length = userbus::make_name(userbus::Kind::Down, number, name);
    const auto* const address = reinterpret_cast<const sockaddr*>(&name);
    if (next().bind(descriptor, address, length) == 0 && next().connect(descriptor, address, length) == 0)
      return descriptor;
  }
  next().close(descriptor);
  return -1;
}

/// Gives @p to the time limits of @p from.
void copy_limits(int from, int to) noexcept {
  for (const int limit : {SO_RCVTIMEO, SO_SNDTIMEO}) {
    timeval time{};
    socklen_t size = sizeof time;
    if (next().getsockopt(from, SOL_SOCKET, limit, &time, &size) == 0)
      next().setsockopt(to, SOL_SOCKET, limit, &time, size);
  }
}

}  // namespace

void take_down(int descriptor, const userbus::Name& name) noexcept {
  userbus::Name present{};
  if (!userbus::name_of(descriptor, present) || present.number != name.number) return;
  const int nonblocking = (fcntl(descriptor, F_GETFL) & O_NONBLOCK) != 0 ? SOCK_NONBLOCK : 0;
  const int at_exec = (fcntl(descriptor, F_GETFD) & FD_CLOEXEC) != 0 ? O_CLOEXEC : 0;
  const int substitute = silent_socket(nonblocking | SOCK_CLOEXEC);
  if (substitute < 0) return;
  copy_limits(descriptor, substitute);
  dup3(substitute, descriptor, at_exec);
  next().close(substitute);
}

}  // namespace preload
