#include "can/preload/time/process/turn_descriptor.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "can/preload/next.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/lock.hpp"
#include "can/preload/time/turn/turn.hpp"

namespace preload {

namespace {

/// Below what select(2) takes, should a program count on that, and above what programs open.
constexpr int kHidden = 960;

/// Where the hidden descriptors begin where no process may have so many.
int lowest_hidden() noexcept {
  constexpr int kReserve = 16;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur > kHidden + kReserve) return kHidden;
  return limit.rlim_cur > 2 * kReserve ? static_cast<int>(limit.rlim_cur) - kReserve : 0;
}

}  // namespace

int hide(int socket) noexcept {
  if (socket < 0) return socket;
  const int moved = fcntl(socket, F_DUPFD_CLOEXEC, lowest_hidden());
  if (moved < 0) return socket;
  next().close(socket);
  return moved;
}

void take_part(int socket) noexcept {
  const TimeLock lock;
  use_turn_socket(socket);
  const userbus::TimeMessage message{.word = userbus::TimeMessage::Word::Join,
                                     .flags = 0,
                                     .now_ns = 0,
                                     .until_ns = 0,
                                     .process = getpid(),
                                     .reserved = 0};
  if (userbus::tell_time(socket, message) && begin_turn(true) == userbus::TurnOutcome::Turn) return;
  go_scaled(1, present(), machine_present(), wall_time(0));
}

bool is_hidden(int descriptor) noexcept {
  return by_turns() && descriptor >= 0 && descriptor == turn_socket();
}

}  // namespace preload
