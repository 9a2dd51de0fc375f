#include "can/preload/time/wait/timer.hpp"

#include "can/preload/next.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/alarm.hpp"

namespace preload {

namespace {

constexpr int kMostTimers = 256;

/// The first is the interval timer of the process.
BusTimer timers[kMostTimers];
/// Behind the last that has ever been used.
int timers_end = 1;

/// What identifiers of timer_create(2) begin with, which the kernel's do not.
constexpr uintptr_t kIdentifier = 0x42550000;

/// How often @p timer has expired by now; sets it to its next expiry.
uint64_t expire(BusTimer& timer) noexcept {
  const int64_t now = present();
  if (timer.expiry > now) return 0;
  if (timer.interval == 0) {
    timer.expiry = kNoInstant;
    return 1;
  }
  const int64_t more = (now - timer.expiry) / timer.interval;
  timer.expiry = after(timer.expiry, (more + 1) * timer.interval);
  return static_cast<uint64_t>(more) + 1;
}

}  // namespace

BusTimer& interval_timer() noexcept {
  timers[0].used = true;
  timers[0].alarm = Alarm::Signal;
  timers[0].signal = SIGALRM;
  return timers[0];
}

BusTimer* new_timer() noexcept {
  for (int i = 1; i < kMostTimers; ++i) {
    if (timers[i].used) continue;
    timers[i] = BusTimer{};
    timers[i].used = true;
    if (i >= timers_end) timers_end = i + 1;
    return &timers[i];
  }
  return nullptr;
}

BusTimer* timer_at(int descriptor) noexcept {
  for (int i = 1; i < timers_end; ++i)
    if (timers[i].used && timers[i].alarm == Alarm::Descriptor && timers[i].descriptor == descriptor)
      return &timers[i];
  return nullptr;
}

BusTimer* timer_of(timer_t identifier) noexcept {
  const uintptr_t index = reinterpret_cast<uintptr_t>(identifier) - kIdentifier;
  return index > 0 && index < kMostTimers && timers[index].used ? &timers[index] : nullptr;
}

timer_t identifier_of(const BusTimer& timer) noexcept {
  return reinterpret_cast<timer_t>(kIdentifier + static_cast<uintptr_t>(&timer - timers));
}

void forget_timer(int descriptor) noexcept {
  if (timers_end == 1) return;
  const TimeLock lock;
  if (BusTimer* const timer = timer_at(descriptor); timer != nullptr) *timer = BusTimer{};
}

void forget_timers() noexcept {
  for (int i = 0; i < timers_end; ++i)
    if (timers[i].alarm != Alarm::Descriptor) timers[i] = BusTimer{};
}

void set_timer(BusTimer& timer, const itimerspec& time, bool absolute, itimerspec* before) noexcept {
  const itimerspec left = time_left(timer);
  const int64_t value = ns_of(time.it_value);
  timer.interval = ns_of(time.it_interval);
  timer.overruns = 0;
  timer.expiry = kNoInstant;
  if (value != 0) timer.expiry = absolute ? value - timer.offset : after(present(), value);
  if (before != nullptr) *before = left;
}

itimerspec time_left(const BusTimer& timer) noexcept {
  itimerspec left{};
  left.it_interval = timespec_of(timer.interval);
  if (timer.expiry == kNoInstant) return left;
  const int64_t ns = timer.expiry - present();
  left.it_value = timespec_of(ns > 0 ? ns : 1);
  return left;
}

int64_t first_expiry() noexcept {
  int64_t first = kNoInstant;
  for (int i = 0; i < timers_end; ++i)
    if (timers[i].used && timers[i].expiry < first) first = timers[i].expiry;
  return first;
}

bool fire_due_timers(Thread& self, TimeLock& lock) noexcept {
  bool any = false;
  for (int i = 0; i < timers_end; ++i) {
    BusTimer& timer = timers[i];
    if (!timer.used || timer.expiry > present()) continue;
    const uint64_t count = expire(timer);
    timer.overruns = static_cast<int>(count - 1);
    any = true;
    if (timer.alarm == Alarm::Descriptor)
      next().write(timer.descriptor, &count, sizeof count);
    else
      raise_alarm(timer, self, lock);
  }
  return any;
}

}  // namespace preload
