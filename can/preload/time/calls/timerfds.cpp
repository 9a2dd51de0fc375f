// timerfd_create, timerfd_settime, timerfd_gettime: an eventfd, which counts as a timerfd does, stands for it.
#include <cerrno>

#include <sys/eventfd.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/next.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/timer.hpp"

namespace preload {

namespace {

int create_descriptor(int64_t offset, int flags) noexcept {
  static_assert(int{TFD_CLOEXEC} == int{EFD_CLOEXEC} && int{TFD_NONBLOCK} == int{EFD_NONBLOCK});
  const int descriptor = eventfd(0, flags);
  if (descriptor < 0) return -1;
  const TimeLock lock;
  BusTimer* const timer = new_timer();
  if (timer == nullptr) {
    next().close(descriptor);
    return failed(EMFILE);
  }
  timer->alarm = Alarm::Descriptor;
  timer->descriptor = descriptor;
  timer->offset = offset;
  return descriptor;
}

/// What has expired before is not to be read any more.
void drain(int descriptor) noexcept {
  pollfd counted{descriptor, POLLIN, 0};
  uint64_t count = 0;
  if (real().poll(&counted, 1, 0) == 1 && next().read(descriptor, &count, sizeof count) < 0) return;
}

itimerspec machine_spec(const itimerspec& time, bool absolute) noexcept {
  const int64_t value = ns_of(time.it_value);
  const int64_t machines = value == 0 ? 0 : absolute ? machine_instant(value) : machine_duration(value);
  return {.it_interval = timespec_of(machine_duration(ns_of(time.it_interval))),
          .it_value = timespec_of(value != 0 && machines == 0 ? 1 : machines)};
}

}  // namespace

}  // namespace preload

using preload::BusTimer;
using preload::by_turns;
using preload::failed;
using preload::real;
using preload::TimeLock;
using preload::timer_at;

PRELOAD_EXPORT int timerfd_create(__clockid_t clock, int flags) noexcept {
  int64_t offset = 0;
  if (by_turns() && preload::is_of_bus(clock, offset)) return preload::create_descriptor(offset, flags);
  // absolute times are set by the machine's monotonic clock
  return real().timerfd_create(preload::by_machine() ? clock : CLOCK_MONOTONIC, flags);
}

PRELOAD_EXPORT int timerfd_settime(int descriptor, int flags, const itimerspec* time,
                                   itimerspec* before) noexcept {
  const bool absolute = (flags & TFD_TIMER_ABSTIME) != 0;
  if (preload::by_machine()) return real().timerfd_settime(descriptor, flags, time, before);
  if (!preload::is_valid(time->it_value) || !preload::is_valid(time->it_interval)) return failed(EINVAL);
  const TimeLock lock;
  BusTimer* const timer = timer_at(descriptor);
  if (timer == nullptr) {
    const itimerspec scaled = preload::machine_spec(*time, absolute);
    return real().timerfd_settime(descriptor, flags & TFD_TIMER_ABSTIME, &scaled, before);
  }
  preload::set_timer(*timer, *time, absolute, before);
  preload::drain(descriptor);
  return 0;
}

PRELOAD_EXPORT int timerfd_gettime(int descriptor, itimerspec* time) noexcept {
  if (!by_turns()) return real().timerfd_gettime(descriptor, time);
  const TimeLock lock;
  const BusTimer* const timer = timer_at(descriptor);
  if (timer == nullptr) return real().timerfd_gettime(descriptor, time);
  *time = preload::time_left(*timer);
  return 0;
}
