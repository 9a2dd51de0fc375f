#include "can/preload/time/wait/scheduler.hpp"

#include <cerrno>
#include <climits>

#include <unistd.h>

#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/turn/turn.hpp"
#include "can/preload/time/wait/signals.hpp"
#include "can/preload/time/wait/stuck.hpp"
#include "can/preload/time/wait/wait.hpp"

namespace preload {

namespace {

Threads all_threads;
std::atomic<int> waits_for_addresses;

/// Its value tells a thread that ends that it has been known.
pthread_key_t ending;
pthread_once_t ending_is_made = PTHREAD_ONCE_INIT;

void note_end(void* thread) noexcept {
  set_own_thread(nullptr);
  const TimeLock lock;
  if (by_turns()) end_thread(*static_cast<Thread*>(thread));
}

void make_ending() noexcept {
  pthread_key_create(&ending, note_end);
}

/// The calling thread is @p thread, until it ends.
void become(Thread& thread) noexcept {
  set_own_thread(&thread);
  thread.handle = pthread_self();
  thread.id = gettid();
  pthread_once(&ending_is_made, make_ending);
  pthread_setspecific(ending, &thread);
}

// What a thread's `go` says.
constexpr int kGo = 1;
constexpr int kLook = 2;  ///< it may have to coordinate

/// Whether @p thread waits only for its turn among the threads: one that spins may not let it have that.
bool waits_for_threads(const Thread& thread) noexcept {
  return thread.place == Place::Runnable || (thread.place == Place::Waiting && thread.wait.deadline <= present());
}

/// Who goes on next: a thread that is runnable, or one whose time has come.
Thread* next_thread() noexcept {
  if (all_threads.runnable.first() != nullptr) return all_threads.runnable.first();
  for (Thread* thread = all_threads.waiting.first(); thread != nullptr; thread = thread->following)
    if (waits_for_threads(*thread)) return thread;
  return nullptr;
}

/// Lets who is next go on beside those that run, if they spin or are blocked.
void pass_stuck_runners() noexcept {
  Thread* const next = next_thread();
  if (all_threads.running == 0 || next == nullptr || !are_runners_stuck()) return;
  if (next->place == Place::Waiting) make_runnable(*next, Ended::Deadline);
  release_first();
}

// Threads that sleep are not told that one which runs has made them runnable: they would go on when it waits, and
// it may never do so. Some of them watch; two, as one of those may be the next to run.
constexpr int kMostWatchmen = 2;
constexpr int64_t kWatch = 25 * kNsOfMillisecond;
constexpr int64_t kPatience = 5 * kNsOfMillisecond;

void begin_watch(Thread& self) noexcept {
  self.watches = all_threads.watchmen < kMostWatchmen;
  if (self.watches) ++all_threads.watchmen;
}

void end_watch(Thread& self) noexcept {
  if (self.watches) --all_threads.watchmen;
  self.watches = false;
}

/// One sleep of @p self, after which it looks again. A signal ends its wait.
void sleep_once(Thread& self, TimeLock& lock) noexcept {
  const bool is_next = waits_for_threads(self);
  if (!is_next) begin_watch(self);
  const timespec limit = timespec_of(is_next ? kPatience : kWatch);
  const int processor = processor_of_turns();
  hold_signals(self);
  lock.release();
  userbus::begin_stay(self.stay, processor);
  const int error = sleep_until_called(self, is_next || self.watches ? &limit : nullptr);
  lock.take();
  userbus::end_stay(self.stay);
  end_watch(self);
  if (self.go == kLook) self.go = 0;
  self.wait.polled = false;  // others have run
  if (error == EINTR && self.place == Place::Waiting) {
    make_runnable(self, Ended::Signal);
    if (by_turns() && !has_turn()) want_turn();
  }
  if (error == ETIMEDOUT) pass_stuck_runners();
}

/// Whether the process acts: those who can go on may.
bool may_act() noexcept {
  return has_turn() || !by_turns();
}

Ended sleep_until_released(Thread& self, TimeLock& lock) noexcept {
  Threads& all = all_threads;
  while (self.go != kGo) {
    if (all.running == 0 && may_act() && all.runnable.first() != nullptr) {
      if (all.runnable.first() != &self) hold_signals(self);  // a handler that jumps would not call it
      release_first();
    } else if (all.running == 0 && all.coordinator == nullptr) {
      all.coordinator = &self;
      coordinate(self, lock);
      all.coordinator = nullptr;
    } else {
      sleep_once(self, lock);
    }
  }
  self.go = 0;
  const Ended ended = self.ended;  // a handler may wait, too
  pthread_setcancelstate(self.cancel_state, nullptr);
  if (!self.holds_signals) return ended;
  lock.release();
  release_signals(self);  // those that have come since the sleep
  lock.take();
  return ended;
}

}  // namespace

Threads& threads() noexcept {
  return all_threads;
}

Thread& this_thread() noexcept {
  if (Thread* const known = own_thread(); known != nullptr) return *known;
  static Thread spare;  // without memory threads share one, and time is not right any more
  Thread* thread = new_thread();
  if (thread == nullptr) thread = &spare;
  ++all_threads.running;
  become(*thread);
  return *thread;
}

void make_runnable(Thread& thread, Ended ended) noexcept {
  all_threads.waiting.remove(thread);
  all_threads.runnable.append(thread);
  thread.place = Place::Runnable;
  thread.ended = ended;
  if (ended == Ended::Signal) ++all_threads.interruptions;
}

void release_first() noexcept {
  Thread& thread = *all_threads.runnable.first();
  all_threads.runnable.remove(thread);
  thread.place = Place::Running;
  ++all_threads.running;
  thread.patience = Patience{};
  call_thread(thread, kGo);
}

void release_all() noexcept {
  while (all_threads.waiting.first() != nullptr) make_runnable(*all_threads.waiting.first(), Ended::Gone);
  while (all_threads.runnable.first() != nullptr) release_first();
}

void begin_wait(Thread& self, const Wait& wait) noexcept {
  self.wait = wait;
  self.go = 0;
  self.place = Place::Waiting;
  all_threads.waiting.append(self);
  if (wait.address != nullptr) ++waits_for_addresses;
}

void cancel_wait(Thread& self) noexcept {
  (self.place == Place::Waiting ? all_threads.waiting : all_threads.runnable).remove(self);
  self.place = Place::Running;
  self.go = 0;
  if (self.wait.address != nullptr) --waits_for_addresses;
}

int count_waits_for_addresses() noexcept {
  return waits_for_addresses;
}

Ended finish_wait(Thread& self, TimeLock& lock) noexcept {
  const bool has_address = self.wait.address != nullptr;
  pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &self.cancel_state);  // that ends a wait by interrupt()
  --all_threads.running;
  self.has_stopped = true;
  const Ended ended = sleep_until_released(self, lock);
  self.has_stopped = false;
  if (has_address) --waits_for_addresses;
  return ended;
}

void abandon_wait() noexcept {
  Thread* const self = own_thread();
  if (self == nullptr) return;
  userbus::end_stay(self->stay);
  if (TimeLock::is_mine()) TimeLock::forget();
  if (!self->has_stopped && self->place == Place::Running) return;
  TimeLock lock;
  if (!self->has_stopped) return cancel_wait(*self);
  end_watch(*self);
  if (self->place == Place::Waiting) make_runnable(*self, Ended::Signal);
  if (all_threads.coordinator == self) all_threads.coordinator = nullptr;
  const bool has_address = self->wait.address != nullptr;
  self->wait = Wait{};
  self->holds_signals = false;  // the jump, or the end of the handler, says which are blocked
  if (self->place == Place::Runnable) {
    if (by_turns() && !has_turn()) want_turn();
    sleep_until_released(*self, lock);
  } else {
    self->go = 0;
    pthread_setcancelstate(self->cancel_state, nullptr);
  }
  self->has_stopped = false;
  if (has_address) --waits_for_addresses;
}

Thread* announce_thread() noexcept {
  Thread* const thread = new_thread();
  if (thread == nullptr) return nullptr;
  thread->place = Place::Runnable;
  thread->ended = Ended::Ready;
  thread->wait = Wait{};
  all_threads.runnable.append(*thread);
  return thread;
}

void begin_thread(Thread& self) noexcept {
  become(self);
  TimeLock lock;
  ++all_threads.running;  // it is not, but finish_wait() takes one off
  finish_wait(self, lock);
}

void end_thread(Thread& thread) noexcept {
  Threads& all = all_threads;
  if (thread.place == Place::Runnable) all.runnable.remove(thread);
  if (thread.place == Place::Running) --all.running;
  const pthread_t handle = thread.handle;
  free_thread(thread);
  wake_waiting(reinterpret_cast<const void*>(handle), INT_MAX, UINT32_MAX);  // who joins it
  if (all.running > 0) return;
  if (all.runnable.first() != nullptr && may_act())
    release_first();
  else if (all.coordinator == nullptr && all.waiting.first() != nullptr)
    call_thread(*all.waiting.first(), kLook);
  else if (all.coordinator == nullptr && all.runnable.first() != nullptr)
    call_thread(*all.runnable.first(), kLook);
}

void forget_other_threads() noexcept {
  TimeLock::forget();
  Thread* const self = own_thread();
  forget_threads_but(self);
  all_threads = Threads{};
  waits_for_addresses = 0;
  if (self == nullptr) return;
  userbus::end_stay(self->stay);
  self->holds_signals = false;
  self->watches = false;
  self->id = gettid();
  if (self->has_stopped && self->wait.address != nullptr) waits_for_addresses = 1;
  if (self->place == Place::Running) {
    all_threads.running = 1;
  } else {  // a handler of signals has forked in a sleep, which is over when it returns
    self->place = Place::Runnable;
    self->ended = Ended::Signal;
    all_threads.runnable.append(*self);
  }
}

}  // namespace preload
