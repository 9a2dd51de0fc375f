// pthread_rwlock_rdlock, wrlock, their limited forms, unlock.
#include <climits>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/calls/threads/acquire.hpp"
#include "can/preload/time/calls/threads/deadline.hpp"

namespace preload {

namespace {

int lock_until(pthread_rwlock_t* lock, int (*try_once)(pthread_rwlock_t*), int64_t deadline) noexcept {
  Wait wait{};
  wait.address = lock;
  wait.deadline = deadline;
  return acquire(wait, false, [lock, try_once]() noexcept { return try_once(lock); });
}

/// One of pthread_rwlock_clockrdlock and pthread_rwlock_clockwrlock.
struct LimitedLock {
  int (*try_once)(pthread_rwlock_t*);
  int (*by_machine)(pthread_rwlock_t*, clockid_t, const timespec*);

  int operator()(pthread_rwlock_t* lock, clockid_t clock, const timespec* time) const noexcept {
    if (preload::by_machine()) return by_machine(lock, clock, time);
    if (by_turns()) {
      const int error = lock_until(lock, try_once, deadline_of(clock, time));
      if (error != kNotByTurns) return error;
    }
    const timespec end = machine_time_of(clock, time);
    return by_machine(lock, CLOCK_MONOTONIC, &end);
  }
};

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::kNotByTurns;
using preload::real;

PRELOAD_EXPORT int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  if (by_turns()) {
    const int error = preload::lock_until(lock, pthread_rwlock_tryrdlock, preload::kNoInstant);
    if (error != kNotByTurns) return error;
  }
  return real().pthread_rwlock_rdlock(lock);
}

PRELOAD_EXPORT int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  if (by_turns()) {
    const int error = preload::lock_until(lock, pthread_rwlock_trywrlock, preload::kNoInstant);
    if (error != kNotByTurns) return error;
  }
  return real().pthread_rwlock_wrlock(lock);
}

PRELOAD_EXPORT int pthread_rwlock_clockrdlock(pthread_rwlock_t* lock, clockid_t clock,
                                              const timespec* time) noexcept {
  return preload::LimitedLock{pthread_rwlock_tryrdlock, real().pthread_rwlock_clockrdlock}(lock, clock, time);
}

PRELOAD_EXPORT int pthread_rwlock_clockwrlock(pthread_rwlock_t* lock, clockid_t clock,
                                              const timespec* time) noexcept {
  return preload::LimitedLock{pthread_rwlock_trywrlock, real().pthread_rwlock_clockwrlock}(lock, clock, time);
}

PRELOAD_EXPORT int pthread_rwlock_timedrdlock(pthread_rwlock_t* lock, const timespec* time) noexcept {
  return pthread_rwlock_clockrdlock(lock, CLOCK_REALTIME, time);
}

PRELOAD_EXPORT int pthread_rwlock_timedwrlock(pthread_rwlock_t* lock, const timespec* time) noexcept {
  return pthread_rwlock_clockwrlock(lock, CLOCK_REALTIME, time);
}

PRELOAD_EXPORT int pthread_rwlock_unlock(pthread_rwlock_t* lock) noexcept {
  const int error = real().pthread_rwlock_unlock(lock);
  if (error == 0 && by_turns()) preload::wake(lock, INT_MAX);
  return error;
}
