// pthread_create, pthread_join and its limited forms, pthread_cancel: which threads there are.
#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/calls/threads/deadline.hpp"
#include "can/preload/time/wait/scheduler.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

/// What a new thread is to do.
struct Beginning {
  void* (*function)(void*);
  void* argument;
  Thread* thread;
};

void* begin(void* argument) {
  const Beginning beginning = *static_cast<Beginning*>(argument);
  free(argument);
  begin_thread(*beginning.thread);
  return beginning.function(beginning.argument);
}

int create(pthread_t* handle, const pthread_attr_t* attributes, const Beginning& wanted) noexcept {
  auto* const beginning = static_cast<Beginning*>(malloc(sizeof(Beginning)));
  if (beginning == nullptr) return EAGAIN;
  *beginning = wanted;
  {
    const TimeLock lock;
    beginning->thread = announce_thread();
  }
  Thread* const thread = beginning->thread;
  const int error = thread == nullptr ? EAGAIN : real().pthread_create(handle, attributes, begin, beginning);
  const TimeLock lock;
  if (error == 0) {
    thread->handle = *handle;
    return 0;
  }
  if (thread != nullptr) end_thread(*thread);
  free(beginning);
  return error;
}

struct Joining {
  pthread_t handle;
  bool found;
};

/// Whether thread @p handle has ended, as far as the program's part goes.
bool has_ended(void* argument) noexcept {
  Joining joining{*static_cast<pthread_t*>(argument), false};
  const TimeLock lock;
  for_each_thread(
      [](Thread& thread, void* given) {
        auto& wanted = *static_cast<Joining*>(given);
        if (thread.handle == wanted.handle) wanted.found = true;
      },
      &joining);
  return !joining.found;
}

/// False if it is not over at @p deadline.
bool await_end(pthread_t handle, int64_t deadline) noexcept {
  Wait wait{};
  wait.address = reinterpret_cast<const void*>(handle);
  wait.deadline = deadline;
  for (;;) {
    const Ended ended = wait_unless(wait, has_ended, &handle);
    if (ended == Ended::Deadline) return false;
    if (ended == Ended::Signal) pthread_testcancel();
    if (ended == Ended::Gone || has_ended(&handle)) return true;
  }
}

}  // namespace

}  // namespace preload

using preload::by_turns;
using preload::real;

PRELOAD_EXPORT int pthread_create(pthread_t* handle, const pthread_attr_t* attributes, void* (*function)(void*),
                                  void* argument) noexcept {
  if (!by_turns()) return real().pthread_create(handle, attributes, function, argument);
  return preload::create(handle, attributes, {function, argument, nullptr});
}

PRELOAD_EXPORT int pthread_clockjoin_np(pthread_t handle, void** result, clockid_t clock, const timespec* time) {
  if (preload::by_machine()) return real().pthread_clockjoin_np(handle, result, clock, time);
  if (by_turns() && !preload::await_end(handle, preload::deadline_of(clock, time))) return ETIMEDOUT;
  if (by_turns()) return real().pthread_join(handle, result);
  const timespec end = preload::machine_time_of(clock, time);
  return real().pthread_clockjoin_np(handle, result, CLOCK_MONOTONIC, &end);
}

PRELOAD_EXPORT int pthread_timedjoin_np(pthread_t handle, void** result, const timespec* time) {
  if (preload::by_machine()) return real().pthread_timedjoin_np(handle, result, time);
  return pthread_clockjoin_np(handle, result, CLOCK_REALTIME, time);
}

PRELOAD_EXPORT int pthread_join(pthread_t handle, void** result) {
  if (by_turns()) preload::await_end(handle, preload::kNoInstant);
  return real().pthread_join(handle, result);
}

PRELOAD_EXPORT int pthread_cancel(pthread_t handle) {
  const int error = real().pthread_cancel(handle);
  if (error == 0 && by_turns()) preload::interrupt(handle);
  return error;
}
