// setitimer, getitimer, alarm, and the timers of timer_create: a signal comes at an instant of the bus.
#include <cerrno>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/timer.hpp"

namespace preload {

namespace {

itimerspec spec_of(const itimerval& value) noexcept {
  return {.it_interval = timespec_of(ns_of(value.it_interval)), .it_value = timespec_of(ns_of(value.it_value))};
}

itimerval value_of(const itimerspec& spec) noexcept {
  return {.it_interval = timeval_of(ns_of(spec.it_interval)), .it_value = timeval_of(ns_of(spec.it_value))};
}

/// Each part of @p spec as the machine takes it for @p scaled: pace by pace.
itimerval machine_value(const itimerval& value) noexcept {
  return {.it_interval = timeval_of(machine_duration(ns_of(value.it_interval))),
          .it_value = timeval_of(machine_duration(ns_of(value.it_value)))};
}

/// What @p event asks for, for a new timer.
bool take_event(const sigevent* event, BusTimer& timer) noexcept {
  timer.alarm = Alarm::Signal;
  timer.signal = SIGALRM;
  if (event == nullptr) return true;
  timer.signal = event->sigev_signo;
  timer.value = event->sigev_value;
  switch (event->sigev_notify) {
    case SIGEV_NONE:
      timer.alarm = Alarm::None;
      return true;
    case SIGEV_SIGNAL:
      return true;
    case SIGEV_THREAD_ID:
      timer.alarm = Alarm::SignalToThread;
      timer.thread = event->_sigev_un._tid;
      return true;
    case SIGEV_THREAD:
      timer.alarm = Alarm::Function;
      timer.function = event->sigev_notify_function;
      return true;
    default:
      return false;
  }
}

int create_timer(int64_t offset, const sigevent* event, timer_t* identifier) noexcept {
  const TimeLock lock;
  BusTimer* const timer = new_timer();
  if (timer == nullptr) return failed(EAGAIN);
  timer->offset = offset;
  if (!take_event(event, *timer)) {
    *timer = BusTimer{};
    return failed(EINVAL);
  }
  *identifier = identifier_of(*timer);
  return 0;
}

}  // namespace

}  // namespace preload

using preload::BusTimer;
using preload::by_turns;
using preload::failed;
using preload::real;
using preload::TimeLock;
using preload::timer_of;

PRELOAD_EXPORT int setitimer(__itimer_which_t which, const itimerval* value, itimerval* before) noexcept {
  if (which != ITIMER_REAL || preload::by_machine())
    return real().setitimer(static_cast<int>(which), value, before);
  if (!by_turns()) {
    const itimerval scaled = preload::machine_value(*value);
    return real().setitimer(static_cast<int>(which), &scaled, before);
  }
  const TimeLock lock;
  BusTimer& timer = preload::interval_timer();
  if (before != nullptr) *before = preload::value_of(preload::time_left(timer));
  preload::set_timer(timer, preload::spec_of(*value), false);
  return 0;
}

PRELOAD_EXPORT int getitimer(__itimer_which_t which, itimerval* value) noexcept {
  if (which != ITIMER_REAL || !by_turns()) return real().getitimer(static_cast<int>(which), value);
  const TimeLock lock;
  *value = preload::value_of(preload::time_left(preload::interval_timer()));
  return 0;
}

PRELOAD_EXPORT unsigned alarm(unsigned seconds) noexcept {
  if (preload::by_machine()) return real().alarm(seconds);
  const itimerval value{.it_interval = {}, .it_value = {.tv_sec = seconds, .tv_usec = 0}};
  itimerval before{};
  if (setitimer(ITIMER_REAL, &value, &before) != 0) return 0;
  const bool fraction = before.it_value.tv_usec != 0;
  return static_cast<unsigned>(before.it_value.tv_sec) + (fraction ? 1 : 0);
}

PRELOAD_EXPORT int timer_create(clockid_t clock, sigevent* event, timer_t* identifier) noexcept {
  int64_t offset = 0;
  if (!by_turns() || !preload::is_of_bus(clock, offset)) return real().timer_create(clock, event, identifier);
  return preload::create_timer(offset, event, identifier);
}

PRELOAD_EXPORT int timer_settime(timer_t identifier, int flags, const itimerspec* time,
                                 itimerspec* before) noexcept {
  if (!by_turns()) return real().timer_settime(identifier, flags, time, before);
  const TimeLock lock;
  BusTimer* const timer = timer_of(identifier);
  if (timer == nullptr) return real().timer_settime(identifier, flags, time, before);
  if (!preload::is_valid(time->it_value) || !preload::is_valid(time->it_interval)) return failed(EINVAL);
  preload::set_timer(*timer, *time, (flags & TIMER_ABSTIME) != 0, before);
  return 0;
}

PRELOAD_EXPORT int timer_gettime(timer_t identifier, itimerspec* time) noexcept {
  if (!by_turns()) return real().timer_gettime(identifier, time);
  const TimeLock lock;
  const BusTimer* const timer = timer_of(identifier);
  if (timer == nullptr) return real().timer_gettime(identifier, time);
  *time = preload::time_left(*timer);
  return 0;
}

PRELOAD_EXPORT int timer_getoverrun(timer_t identifier) noexcept {
  if (!by_turns()) return real().timer_getoverrun(identifier);
  const TimeLock lock;
  const BusTimer* const timer = timer_of(identifier);
  return timer == nullptr ? real().timer_getoverrun(identifier) : timer->overruns;
}

PRELOAD_EXPORT int timer_delete(timer_t identifier) noexcept {
  if (!by_turns()) return real().timer_delete(identifier);
  const TimeLock lock;
  BusTimer* const timer = timer_of(identifier);
  if (timer == nullptr) return real().timer_delete(identifier);
  *timer = BusTimer{};
  return 0;
}
