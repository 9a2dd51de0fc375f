// pthread_cond_wait, timedwait, clockwait, signal, broadcast: threads wait in the order in which they came.
#include <climits>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/calls/threads/deadline.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

constexpr int kWaitsByMachine = -1;

/// Whether other processes may have @p condition, too: then nobody here knows when it is signalled.
bool is_shared(const pthread_cond_t* condition) noexcept {
  constexpr unsigned kShared = 1;
  return (condition->__data.__wrefs & kShared) != 0;
}

/// The clock of pthread_cond_timedwait(3), an attribute of @p condition.
clockid_t clock_of(const pthread_cond_t* condition) noexcept {
  constexpr unsigned kMonotonic = 2;
  return (condition->__data.__wrefs & kMonotonic) != 0 ? CLOCK_MONOTONIC : CLOCK_REALTIME;
}

bool unlock(void* mutex) noexcept {
  pthread_mutex_unlock(static_cast<pthread_mutex_t*>(mutex));
  return false;
}

/// kWaitsByMachine, with the mutex locked still, where it cannot be waited by turns.
int wait_for_condition(pthread_cond_t* condition, pthread_mutex_t* mutex, int64_t deadline) noexcept {
  Wait wait{};
  wait.address = condition;
  wait.deadline = deadline;
  bool unlocked = false;
  struct Argument {
    pthread_mutex_t* mutex;
    bool* unlocked;
  } argument{mutex, &unlocked};
  const auto release = [](void* given) noexcept {
    const auto& both = *static_cast<Argument*>(given);
    *both.unlocked = true;
    return unlock(both.mutex);
  };
  const Ended ended = wait_unless(wait, release, &argument);
  if (!unlocked) return kWaitsByMachine;
  const int error = pthread_mutex_lock(mutex);
  if (ended == Ended::Signal) pthread_testcancel();
  if (error != 0) return error;
  return ended == Ended::Deadline ? ETIMEDOUT : 0;
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::kWaitsByMachine;
using preload::real;
using preload::wait_for_condition;

PRELOAD_EXPORT int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  if (by_turns() && !preload::is_shared(condition)) {
    const int error = wait_for_condition(condition, mutex, preload::kNoInstant);
    if (error != kWaitsByMachine) return error;
  }
  return real().pthread_cond_wait(condition, mutex);
}

PRELOAD_EXPORT int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                                          const timespec* time) {
  if (preload::by_machine()) return real().pthread_cond_clockwait(condition, mutex, clock, time);
  if (!preload::is_valid(*time)) return EINVAL;
  if (by_turns() && !preload::is_shared(condition)) {
    const int error = wait_for_condition(condition, mutex, preload::deadline_of(clock, time));
    if (error != kWaitsByMachine) return error;
  }
  const timespec end = preload::machine_time_of(clock, time);
  return real().pthread_cond_clockwait(condition, mutex, CLOCK_MONOTONIC, &end);
}

PRELOAD_EXPORT int pthread_cond_timedwait(pthread_cond_t* condition, pthread_mutex_t* mutex,
                                          const timespec* time) {
  if (preload::by_machine()) return real().pthread_cond_timedwait(condition, mutex, time);
  return pthread_cond_clockwait(condition, mutex, preload::clock_of(condition), time);
}

// The C library's own waits, which there are when the hub has gone, are woken, too.

PRELOAD_EXPORT int pthread_cond_signal(pthread_cond_t* condition) noexcept {
  if (by_turns() && preload::wake(condition, 1) == 1) return 0;
  return real().pthread_cond_signal(condition);
}

PRELOAD_EXPORT int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
  if (by_turns()) preload::wake(condition, INT_MAX);
  return real().pthread_cond_broadcast(condition);
}
