// sem_wait, timedwait, clockwait, post.
#include <cstring>

#include "can/preload/calls/exported.hpp"
#include "can/preload/calls/failed.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/calls/threads/acquire.hpp"
#include "can/preload/time/calls/threads/deadline.hpp"
#include "can/preload/time/turn/turn.hpp"

namespace preload {

namespace {

/// Whether other processes may have @p semaphore, too; the C library keeps that behind its value.
bool is_shared(const sem_t* semaphore) noexcept {
  int shared = 0;
  memcpy(&shared, reinterpret_cast<const char*>(semaphore) + sizeof(uint64_t), sizeof shared);
  return shared != 0;
}

bool has_value(const void* semaphore) noexcept {
  int value = 0;
  sem_getvalue(const_cast<sem_t*>(static_cast<const sem_t*>(semaphore)), &value);
  return value > 0;
}

/// An errno, 0 or kNotByTurns.
int take_until(sem_t* semaphore, int64_t deadline) noexcept {
  const auto take = [semaphore]() noexcept {
    if (sem_trywait(semaphore) == 0) return 0;
    return errno == EAGAIN ? EBUSY : errno;
  };
  const int number = errno;
  Wait wait{};
  wait.address = semaphore;
  wait.deadline = deadline;
  wait.is_over = is_shared(semaphore) ? has_value : nullptr;
  wait.subject = semaphore;
  const int error = acquire(wait, true, take);
  if (error == EINTR) pthread_testcancel();
  if (error == 0) errno = number;
  return error;
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::failed;
using preload::kNotByTurns;
using preload::real;

PRELOAD_EXPORT int sem_wait(sem_t* semaphore) {
  if (by_turns()) {
    const int error = preload::take_until(semaphore, preload::kNoInstant);
    if (error != kNotByTurns) return error == 0 ? 0 : failed(error);
  }
  return real().sem_wait(semaphore);
}

PRELOAD_EXPORT int sem_clockwait(sem_t* semaphore, clockid_t clock, const timespec* time) {
  if (preload::by_machine()) return real().sem_clockwait(semaphore, clock, time);
  if (!preload::is_valid(*time)) return failed(EINVAL);
  if (by_turns()) {
    const int error = preload::take_until(semaphore, preload::deadline_of(clock, time));
    if (error != kNotByTurns) return error == 0 ? 0 : failed(error);
  }
  const timespec end = preload::machine_time_of(clock, time);
  return real().sem_clockwait(semaphore, CLOCK_MONOTONIC, &end);
}

PRELOAD_EXPORT int sem_timedwait(sem_t* semaphore, const timespec* time) {
  if (preload::by_machine()) return real().sem_timedwait(semaphore, time);
  return sem_clockwait(semaphore, CLOCK_REALTIME, time);
}

PRELOAD_EXPORT int sem_post(sem_t* semaphore) noexcept {
  if (!by_turns()) return real().sem_post(semaphore);
  if (preload::is_shared(semaphore)) preload::note_touched();
  const int outcome = real().sem_post(semaphore);
  if (outcome == 0) preload::wake(semaphore, 1);
  return outcome;
}
