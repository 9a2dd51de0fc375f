// nanosleep, clock_nanosleep, usleep, sleep, sched_yield.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/instant.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

/// Sleeps until @p deadline of the bus. Returns what is left of it after a signal, else 0.
int64_t sleep_until(int64_t deadline) noexcept {
  Wait wait{};
  wait.deadline = deadline;
  if (by_turns()) {
    const Ended ended = wait_for(wait);
    if (ended == Ended::Deadline) return 0;
    if (ended == Ended::Signal) return deadline > present() ? deadline - present() : 1;
  }
  const timespec end = timespec_of(machine_instant(deadline));
  if (real().clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &end, nullptr) == 0) return 0;
  return deadline > present() ? deadline - present() : 1;
}

}  // namespace

}  // namespace preload

using preload::by_machine;
using preload::present;
using preload::real;
using preload::sleep_until;

PRELOAD_EXPORT int nanosleep(const timespec* wanted, timespec* rest) {
  if (by_machine()) return real().nanosleep(wanted, rest);
  if (!preload::is_valid(*wanted)) return preload::failed(EINVAL);
  const int64_t left = sleep_until(preload::after(present(), preload::ns_of(*wanted)));
  if (left == 0) return 0;
  if (rest != nullptr) *rest = preload::timespec_of(left);
  return preload::failed(EINTR);
}

PRELOAD_EXPORT int clock_nanosleep(clockid_t clock, int flags, const timespec* wanted, timespec* rest) {
  int64_t offset = 0;
  if (by_machine() || !preload::is_of_bus(clock, offset))
    return real().clock_nanosleep(clock, flags, wanted, rest);
  if (!preload::is_valid(*wanted)) return EINVAL;
  const bool absolute = (flags & TIMER_ABSTIME) != 0;
  const int64_t wait = preload::ns_of(*wanted);
  const int64_t left = sleep_until(absolute ? wait - offset : preload::after(present(), wait));
  if (left == 0) return 0;
  if (rest != nullptr && !absolute) *rest = preload::timespec_of(left);
  return EINTR;
}

PRELOAD_EXPORT int usleep(useconds_t microseconds) {
  if (by_machine()) return real().usleep(microseconds);
  const int64_t left = sleep_until(preload::after(present(), microseconds * preload::kNsOfMicrosecond));
  return left == 0 ? 0 : preload::failed(EINTR);
}

PRELOAD_EXPORT unsigned sleep(unsigned seconds) {
  if (by_machine()) return real().sleep(seconds);
  const int64_t left = sleep_until(preload::after(present(), seconds * preload::kNsOfSecond));
  return static_cast<unsigned>((left + preload::kNsOfSecond / 2) / preload::kNsOfSecond);
}

PRELOAD_EXPORT int sched_yield() noexcept {
  if (!preload::by_turns()) return real().sched_yield();
  preload::let_others_go();
  return 0;
}
