// sigtimedwait, sigwaitinfo, sigwait, sigsuspend, pause, kill, killpg, sigqueue.
#include <cerrno>

#include <sys/signalfd.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/next.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/turn/turn.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

constexpr timespec kNoTimeForSignals{};

/// A number of @p wanted that is pending, as sigtimedwait(2) gives it until @p deadline.
int take_signal(const sigset_t* wanted, siginfo_t* info, int64_t deadline) noexcept {
  const int pending = signalfd(-1, wanted, SFD_CLOEXEC | SFD_NONBLOCK);
  if (pending < 0) return -1;
  const pollfd ready{pending, POLLIN, 0};
  Wait wait{};
  wait.descriptors = &ready;
  wait.count = 1;
  wait.deadline = deadline;
  wait.polled = true;
  for (;;) {
    const int number = real().sigtimedwait(wanted, info, &kNoTimeForSignals);
    const Ended ended = number < 0 && errno == EAGAIN ? wait_for(wait) : Ended::Gone;
    if (ended == Ended::Ready) continue;
    next().close(pending);
    if (ended == Ended::Deadline) return failed(EAGAIN);
    if (ended == Ended::Signal) return failed(EINTR);
    return number;
  }
}

/// Waits for a handler to have run, with the signals of @p mask blocked meanwhile; nullptr: as they are.
int await_handler(const sigset_t* mask) noexcept {
  if (mask != nullptr && real().ppoll(nullptr, 0, &kNoTimeForSignals, mask) < 0) return -1;
  Wait wait{};
  wait.mask = mask;
  for (;;) {
    const Ended ended = wait_for(wait);
    if (ended == Ended::Signal) return failed(EINTR);
    if (ended == Ended::Gone) return mask != nullptr ? real().sigsuspend(mask) : real().pause();
  }
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::real;

PRELOAD_EXPORT int sigtimedwait(const sigset_t* wanted, siginfo_t* info, const timespec* limit) {
  if (preload::by_machine() || limit == nullptr) {
    if (!by_turns()) return real().sigtimedwait(wanted, info, limit);
    return preload::take_signal(wanted, info, preload::kNoInstant);
  }
  if (!preload::is_valid(*limit)) return preload::failed(EINVAL);
  const int64_t duration = preload::ns_of(*limit);
  if (by_turns()) return preload::take_signal(wanted, info, preload::after(preload::present(), duration));
  const timespec scaled = preload::timespec_of(preload::machine_duration(duration));
  return real().sigtimedwait(wanted, info, &scaled);
}

PRELOAD_EXPORT int sigwaitinfo(const sigset_t* wanted, siginfo_t* info) {
  if (!by_turns()) return real().sigwaitinfo(wanted, info);
  return preload::take_signal(wanted, info, preload::kNoInstant);
}

PRELOAD_EXPORT int sigwait(const sigset_t* wanted, int* number) {
  if (!by_turns()) return real().sigwait(wanted, number);
  const int error = errno;
  int taken = -1;
  do taken = preload::take_signal(wanted, nullptr, preload::kNoInstant);
  while (taken < 0 && errno == EINTR);
  if (taken < 0) return errno;
  errno = error;
  *number = taken;
  return 0;
}

PRELOAD_EXPORT int sigsuspend(const sigset_t* mask) {
  return by_turns() ? preload::await_handler(mask) : real().sigsuspend(mask);
}

PRELOAD_EXPORT int pause() {
  return by_turns() ? preload::await_handler(nullptr) : real().pause();
}

PRELOAD_EXPORT int kill(pid_t process, int number) noexcept {
  if (by_turns() && number != 0) preload::note_touched();
  return real().kill(process, number);
}

PRELOAD_EXPORT int killpg(pid_t group, int number) noexcept {
  return group < 0 ? preload::failed(EINVAL) : kill(-group, number);
}

PRELOAD_EXPORT int sigqueue(pid_t process, int number, const sigval value) noexcept {
  if (by_turns() && number != 0) preload::note_touched();
  return real().sigqueue(process, number, value);
}
