#include "can/preload/time/process/child.hpp"

#include <cerrno>

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include "can/preload/hub.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/hidden.hpp"
#include "can/preload/time/turn/touch.hpp"
#include "can/preload/time/turn/turn.hpp"
#include "can/preload/time/wait/scheduler.hpp"
#include "can/preload/time/wait/timer.hpp"

namespace preload {

namespace {

/// Between the two halves of fork(2).
int forked_socket = -1;

void before_fork() noexcept {
  forked_socket = prepare_child();
}

void after_fork_in_parent() noexcept {
  leave_to_child(forked_socket);
  forked_socket = -1;
}

void after_fork_in_child() noexcept {
  if (!by_turns()) return;
  forget_other_threads();
  forget_timers();
  close_hidden(turn_socket());
  const int socket = forked_socket >= 0 ? forked_socket : hide(join_time(getpid()));
  forked_socket = -1;
  if (socket < 0) return go_scaled(1, present(), machine_present(), wall_time(0));
  fcntl(socket, F_SETFD, FD_CLOEXEC);
  begin_to_see_writes();
  take_part(socket);
}

/// A handler of signals may begin a program in a sleep of its thread.
void leave_processor() noexcept {
  if (Thread* const self = own_thread()) userbus::end_stay(self->stay);
}

}  // namespace

void take_part(int socket) noexcept {
  const TimeLock lock;
  use_turn_socket(socket);
  const userbus::TimeMessage message{.word = userbus::TimeMessage::Word::Join, .process = getpid()};
  if (userbus::tell_time(socket, message) && begin_turn(true) == userbus::TurnOutcome::Turn)
    return note_touched();  // if by execve(2), that has closed what somebody may wait for
  go_scaled(1, present(), machine_present(), wall_time(0));
}

int prepare_child() noexcept {
  leave_processor();
  if (!acts()) return -1;
  const int error = errno;
  tell_present();
  const int socket = hide(join_time(0));
  if (socket >= 0) fcntl(socket, F_SETFD, 0);
  note_sent();  // how far this process may go on has been said before there was another
  errno = error;
  return socket;
}

void leave_to_child(int socket) noexcept {
  const int error = errno;
  if (socket >= 0) close_hidden(socket);
  errno = error;
}

void watch_forks() noexcept {
  pthread_atfork(before_fork, after_fork_in_parent, after_fork_in_child);
}

bool prepare_exec() noexcept {
  leave_processor();
  if (!acts()) return false;
  const TimeLock lock;
  end_turn(present());
  fcntl(turn_socket(), F_SETFD, 0);
  return true;
}

void resume_after_exec() noexcept {
  const int error = errno;
  const TimeLock lock;
  fcntl(turn_socket(), F_SETFD, FD_CLOEXEC);
  begin_turn(true);
  errno = error;
}

}  // namespace preload
