// pthread_barrier_wait.
#include <climits>
#include <cstring>

#include "can/preload/calls/exported.hpp"
#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/lock.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/scheduler.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

/// What the C library keeps in a barrier.
struct BarrierState {
  unsigned in;
  unsigned round;
  unsigned count;  ///< threads that it waits for
  int shared;
};

BarrierState state_of(const pthread_barrier_t* barrier) noexcept {
  static_assert(sizeof(BarrierState) <= sizeof(pthread_barrier_t));
  BarrierState state{};
  memcpy(&state, barrier, sizeof state);
  return state;
}

/// Whether the calling thread, which waits for @p barrier already, is the last one: then the others go on.
bool is_last(void* barrier) noexcept {
  const TimeLock lock;
  unsigned waiting = 0;
  for (const Thread* thread = threads().waiting.first(); thread != nullptr; thread = thread->following)
    if (thread->wait.address == barrier) ++waiting;
  if (waiting < state_of(static_cast<const pthread_barrier_t*>(barrier)).count) return false;
  wake_waiting(barrier, INT_MAX, UINT32_MAX);
  return true;
}

/// Like is_last(), and keeps the answer.
struct Arrival {
  void* barrier;
  bool last;

  static bool note(void* arrival) noexcept {
    auto& self = *static_cast<Arrival*>(arrival);
    return self.last = is_last(self.barrier);
  }
};

}  // namespace

}  // namespace preload

PRELOAD_EXPORT int pthread_barrier_wait(pthread_barrier_t* barrier) noexcept {
  if (!preload::by_turns() || preload::state_of(barrier).shared != 0)
    return preload::real().pthread_barrier_wait(barrier);
  preload::Arrival arrival{barrier, false};
  preload::Wait wait{};
  wait.address = barrier;
  while (preload::wait_unless(wait, preload::Arrival::note, &arrival) == preload::Ended::Signal) continue;
  return arrival.last ? PTHREAD_BARRIER_SERIAL_THREAD : 0;
}
