// The threads of the C standard (threads.h): they are those of pthread.h by other names.
#include <cerrno>
#include <cstdlib>

#include <threads.h>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/real.hpp"

namespace preload {

namespace {

int outcome_of(int error) noexcept {
  switch (error) {
    case 0:
      return thrd_success;
    case EBUSY:
      return thrd_busy;
    case ETIMEDOUT:
      return thrd_timedout;
    case ENOMEM:
    case EAGAIN:
      return thrd_nomem;
    default:
      return thrd_error;
  }
}

pthread_mutex_t* mutex_of(mtx_t* mutex) noexcept {
  static_assert(sizeof(mtx_t) == sizeof(pthread_mutex_t));
  return reinterpret_cast<pthread_mutex_t*>(mutex);
}

pthread_cond_t* condition_of(cnd_t* condition) noexcept {
  static_assert(sizeof(cnd_t) == sizeof(pthread_cond_t));
  return reinterpret_cast<pthread_cond_t*>(condition);
}

struct StandardBeginning {
  thrd_start_t function;
  void* argument;
};

void* begin_standard(void* argument) {
  const StandardBeginning beginning = *static_cast<StandardBeginning*>(argument);
  free(argument);
  return reinterpret_cast<void*>(static_cast<intptr_t>(beginning.function(beginning.argument)));
}

}  // namespace

}  // namespace preload

using preload::condition_of;
using preload::mutex_of;
using preload::outcome_of;

PRELOAD_EXPORT int thrd_create(thrd_t* thread, thrd_start_t function, void* argument) {
  auto* const beginning = static_cast<preload::StandardBeginning*>(malloc(sizeof(preload::StandardBeginning)));
  if (beginning == nullptr) return thrd_nomem;
  *beginning = {function, argument};
  const int error = pthread_create(thread, nullptr, preload::begin_standard, beginning);
  if (error != 0) free(beginning);
  return outcome_of(error);
}

/// What a thread returns that this library has begun; thrd_exit(3) is the C library's, which keeps it likewise.
PRELOAD_EXPORT int thrd_join(thrd_t thread, int* result) {
  void* returned = nullptr;
  const int error = pthread_join(thread, &returned);
  if (error == 0 && result != nullptr) *result = static_cast<int>(reinterpret_cast<intptr_t>(returned));
  return outcome_of(error);
}

PRELOAD_EXPORT int thrd_sleep(const timespec* wanted, timespec* rest) {
  if (nanosleep(wanted, rest) == 0) return 0;
  return errno == EINTR ? -1 : -2;
}

PRELOAD_EXPORT void thrd_yield() {
  sched_yield();
}

PRELOAD_EXPORT int mtx_lock(mtx_t* mutex) {
  return outcome_of(pthread_mutex_lock(mutex_of(mutex)));
}

PRELOAD_EXPORT int mtx_timedlock(mtx_t* mutex, const timespec* time) {
  return outcome_of(pthread_mutex_timedlock(mutex_of(mutex), time));
}

PRELOAD_EXPORT int mtx_unlock(mtx_t* mutex) {
  return outcome_of(pthread_mutex_unlock(mutex_of(mutex)));
}

PRELOAD_EXPORT int cnd_wait(cnd_t* condition, mtx_t* mutex) {
  return outcome_of(pthread_cond_wait(condition_of(condition), mutex_of(mutex)));
}

PRELOAD_EXPORT int cnd_timedwait(cnd_t* condition, mtx_t* mutex, const timespec* time) {
  return outcome_of(pthread_cond_timedwait(condition_of(condition), mutex_of(mutex), time));
}

PRELOAD_EXPORT int cnd_signal(cnd_t* condition) {
  return outcome_of(pthread_cond_signal(condition_of(condition)));
}

PRELOAD_EXPORT int cnd_broadcast(cnd_t* condition) {
  return outcome_of(pthread_cond_broadcast(condition_of(condition)));
}
