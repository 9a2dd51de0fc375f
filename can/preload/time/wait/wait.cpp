#include "can/preload/time/wait/wait.hpp"

#include <climits>

#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/wait/scheduler.hpp"

namespace preload {

namespace {

/// Looks in a row after which a program is taken for one that waits in a loop, and how far time then goes on with
/// each (ns).
constexpr uint32_t kMostLooks = 100'000;
constexpr int64_t kCreep = kNsOfMicrosecond;

std::atomic<uint32_t> looks;

/// Polls in a row after which other threads go on.
constexpr uint32_t kMostPolls = 32;

std::atomic<uint32_t> polls;

/// A signal handler has wanted to wake somebody while its thread had the lock.
std::atomic<bool> wake_was_missed;

void wake_missed() noexcept {
  if (!wake_was_missed.load(std::memory_order_relaxed) || !wake_was_missed.exchange(false)) return;
  ThreadList& waiting = threads().waiting;
  for (Thread* thread = waiting.first(); thread != nullptr;) {
    Thread* const following = thread->following;
    if (thread->wait.address != nullptr) make_runnable(*thread, Ended::Ready);  // it looks, and may wait again
    thread = following;
  }
}

/// Without @p is_done it is not asked.
Ended wait_in_turn(const Wait& wait, bool (*is_done)(void*) = nullptr, void* argument = nullptr) noexcept {
  if (TimeLock::is_mine()) return Ended::Gone;
  TimeLock lock;
  Thread& self = this_thread();
  if (self.place != Place::Running || !by_turns()) return Ended::Gone;
  begin_wait(self, wait);
  wake_missed();
  if (is_done == nullptr) return finish_wait(self, lock);
  lock.release();
  const bool done = is_done(argument);
  lock.take();
  if (!done) return finish_wait(self, lock);
  cancel_wait(self);
  return Ended::Ready;
}

void note_wait() noexcept {
  looks.store(0, std::memory_order_relaxed);
  polls.store(0, std::memory_order_relaxed);
}

void wait_for_others() noexcept {
  Wait moment{};
  moment.deadline = present();
  wait_in_turn(moment);
}

/// Whether nobody waits for an address; what the caller has done before is seen by those who begin to.
bool nobody_waits_for_address() noexcept {
  std::atomic_thread_fence(std::memory_order_seq_cst);
  return count_waits_for_addresses() == 0;
}

}  // namespace

Ended wait_for(const Wait& wait) noexcept {
  note_wait();
  const Ended ended = wait_in_turn(wait);
  if (ended == Ended::Signal) pthread_testcancel();
  return ended;
}

Ended wait_unless(const Wait& wait, bool (*is_done)(void*), void* argument) noexcept {
  note_wait();
  return wait_in_turn(wait, is_done, argument);
}

void interrupt(pthread_t handle) noexcept {
  const TimeLock lock;
  for (Thread* thread = threads().waiting.first(); thread != nullptr; thread = thread->following)
    if (thread->handle == handle) return make_runnable(*thread, Ended::Signal);
}

int wake_waiting(const void* address, int most, uint32_t bits) noexcept {
  int woken = 0;
  for (Thread* thread = threads().waiting.first(); thread != nullptr && woken < most;) {
    Thread* const following = thread->following;
    if (thread->wait.address == address && (thread->wait.bits & bits) != 0) {
      make_runnable(*thread, Ended::Ready);
      ++woken;
    }
    thread = following;
  }
  return woken;
}

int wake(const void* address, int most, uint32_t bits) noexcept {
  if (TimeLock::is_mine()) {
    wake_was_missed = true;
    return 0;
  }
  if (nobody_waits_for_address()) return 0;
  const TimeLock lock;
  wake_missed();
  return wake_waiting(address, most, bits);
}

void note_idle() noexcept {
  if (looks.fetch_add(1, std::memory_order_relaxed) < kMostLooks) return;
  Wait moment{};
  moment.deadline = present() + kCreep;
  wait_in_turn(moment);
}

void note_poll() noexcept {
  if (polls.fetch_add(1, std::memory_order_relaxed) < kMostPolls) return;
  polls.store(0, std::memory_order_relaxed);
  wait_for_others();
}

void let_others_go() noexcept {
  note_idle();
  wait_for_others();
}

}  // namespace preload
