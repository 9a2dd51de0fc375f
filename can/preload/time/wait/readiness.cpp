#include "can/preload/time/wait/readiness.hpp"

#include <cerrno>
#include <climits>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include "can/preload/next.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/turn/touch.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

/// When the limit of time of a socket is over that begins to wait now.
int64_t limit_of(int descriptor, int option) noexcept {
  timeval limit{};
  socklen_t size = sizeof limit;
  if (next().getsockopt(descriptor, SOL_SOCKET, option, &limit, &size) != 0) return kNoInstant;
  const int64_t ns = ns_of(limit);
  return ns == 0 ? kNoInstant : after(present(), ns);
}

bool await_ready(pollfd& wanted, int option) noexcept {
  Wait wait{};
  wait.descriptors = &wanted;
  wait.count = 1;
  wait.deadline = limit_of(wanted.fd, option);
  wait.polled = true;
  for (;;) {
    switch (wait_for(wait)) {
      case Ended::Ready:
        if (real().poll(&wanted, 1, 0) != 0) return true;
        break;
      case Ended::Gone:
        return true;
      case Ended::Deadline:
        errno = EAGAIN;
        return false;
      case Ended::Signal:
        if (restarts_after_signal()) break;
        errno = EINTR;
        return false;
    }
  }
}

/// The kernel's limit of time of a socket is one of the machine: waits for that of the bus before.
bool await_scaled(pollfd& wanted, int option) noexcept {
  const int64_t limit = limit_of(wanted.fd, option);
  if (limit == kNoInstant || (fcntl(wanted.fd, F_GETFL) & O_NONBLOCK) != 0) return true;
  const timespec time = timespec_of(machine_duration(limit - present()));
  const int ready = real().ppoll(&wanted, 1, &time, nullptr);
  if (ready == 0) errno = EAGAIN;
  return ready > 0;
}

bool may_go(int descriptor, int flags, short events, int option) noexcept {
  if (by_machine()) return true;
  if (!by_turns() && (flags & MSG_DONTWAIT) == 0) {
    pollfd wanted{descriptor, events, 0};
    return await_scaled(wanted, option);
  }
  if (!by_turns() || (flags & MSG_DONTWAIT) != 0) return true;
  const int error = errno;
  pollfd wanted{descriptor, events, 0};
  if (real().poll(&wanted, 1, 0) != 0) return true;
  if ((fcntl(descriptor, F_GETFL) & O_NONBLOCK) != 0) {
    note_idle();
    return true;
  }
  if (!await_ready(wanted, option)) return false;
  errno = error;
  return true;
}

}  // namespace

bool may_read(int descriptor, int flags) noexcept {
  return (flags & MSG_ERRQUEUE) != 0 || may_go(descriptor, flags, POLLIN, SO_RCVTIMEO);
}

bool may_write(int descriptor, int flags) noexcept {
  return may_go(descriptor, flags, POLLOUT, SO_SNDTIMEO);
}

bool may_write_out(int descriptor, int flags) noexcept {
  if (!by_turns()) return true;
  note_writing(descriptor);
  return may_write(descriptor, flags);
}

size_t part_to_write(int descriptor, size_t size) noexcept {
  struct stat status {};
  if (!by_turns() || size <= PIPE_BUF) return 0;
  if (fstat(descriptor, &status) != 0 || !S_ISFIFO(status.st_mode)) return 0;
  return (fcntl(descriptor, F_GETFL) & O_NONBLOCK) != 0 ? 0 : PIPE_BUF;
}

bool restarts_after_signal() noexcept {
  bool all_restart = true;
  for (int number = 1; number < NSIG && all_restart; ++number) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0) continue;
    if (action.sa_handler == SIG_DFL || action.sa_handler == SIG_IGN) continue;
    all_restart = (action.sa_flags & SA_RESTART) != 0;
  }
  return all_restart;
}

}  // namespace preload
