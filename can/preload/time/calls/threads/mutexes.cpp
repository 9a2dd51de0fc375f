// pthread_mutex_lock, timedlock, clocklock, unlock: who waits for a mutex lets time go on.
#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/calls/threads/acquire.hpp"
#include "can/preload/time/calls/threads/deadline.hpp"
#include "can/preload/time/turn/turn.hpp"

namespace preload {

namespace {

/// Whether other processes may have @p mutex, too: in its kind, as PTHREAD_MUTEX_INITIALIZER has it.
bool is_shared(const pthread_mutex_t* mutex) noexcept {
  constexpr int kShared = 128;
  return (mutex->__data.__kind & kShared) != 0;
}

/// A thread that has a mutex of this type is told that it would wait for itself.
bool would_wait_for_itself(const pthread_mutex_t* mutex) noexcept {
  constexpr int kTypes = 3;
  return (mutex->__data.__kind & kTypes) == PTHREAD_MUTEX_ERRORCHECK && mutex->__data.__owner == gettid();
}

bool is_free(const void* mutex) noexcept {
  return __atomic_load_n(&static_cast<const pthread_mutex_t*>(mutex)->__data.__lock, __ATOMIC_RELAXED) == 0;
}

int lock_until(pthread_mutex_t* mutex, int64_t deadline) noexcept {
  const int error = pthread_mutex_trylock(mutex);
  if (error != EBUSY) return error;
  if (would_wait_for_itself(mutex)) return EDEADLK;
  Wait wait{};
  wait.address = mutex;
  wait.deadline = deadline;
  wait.is_over = is_shared(mutex) ? is_free : nullptr;
  wait.subject = mutex;
  return acquire(wait, false, [mutex]() noexcept { return pthread_mutex_trylock(mutex); });
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::kNotByTurns;
using preload::real;

PRELOAD_EXPORT int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  if (by_turns())
    if (const int error = preload::lock_until(mutex, preload::kNoInstant); error != kNotByTurns) return error;
  return real().pthread_mutex_lock(mutex);
}

PRELOAD_EXPORT int pthread_mutex_clocklock(pthread_mutex_t* mutex, clockid_t clock,
                                           const timespec* time) noexcept {
  if (preload::by_machine()) return real().pthread_mutex_clocklock(mutex, clock, time);
  if (by_turns()) {
    const int error = preload::lock_until(mutex, preload::deadline_of(clock, time));
    if (error != kNotByTurns) return error;
  }
  const timespec end = preload::machine_time_of(clock, time);
  return real().pthread_mutex_clocklock(mutex, CLOCK_MONOTONIC, &end);
}

PRELOAD_EXPORT int pthread_mutex_timedlock(pthread_mutex_t* mutex, const timespec* time) noexcept {
  if (preload::by_machine()) return real().pthread_mutex_timedlock(mutex, time);
  return pthread_mutex_clocklock(mutex, CLOCK_REALTIME, time);
}

PRELOAD_EXPORT int pthread_mutex_unlock(pthread_mutex_t* mutex) noexcept {
  if (!by_turns()) return real().pthread_mutex_unlock(mutex);
  const bool shared = preload::is_shared(mutex);
  const int error = real().pthread_mutex_unlock(mutex);
  if (error != 0) return error;
  if (shared) preload::note_touched();
  preload::wake(mutex, 1);
  return 0;
}
