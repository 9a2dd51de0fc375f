// What the last thread that comes to wait does for all: it looks what is next, and ends and begins the turns.
#include <cerrno>

#include "can/preload/time/base/clock.hpp"
#include "can/preload/time/base/hidden.hpp"
#include "can/preload/time/base/real.hpp"
#include "can/preload/time/turn/turn.hpp"
#include "can/preload/time/wait/children.hpp"
#include "can/preload/time/wait/poll_set.hpp"
#include "can/preload/time/wait/scheduler.hpp"
#include "can/preload/time/wait/signals.hpp"
#include "can/preload/time/wait/timer.hpp"

namespace preload {

namespace {

using userbus::TurnOutcome;

PollSet poll_set;

/// How often a parent looks for children that are not on the bus (ns of the machine).
constexpr int64_t kLookForChildren = 50 * kNsOfMillisecond;

bool waits_for_children(const Thread& thread) noexcept {
  return thread.wait.for_children;
}

bool is_over(const Thread& thread) noexcept {
  return thread.wait.is_over != nullptr && thread.wait.is_over(thread.wait.subject);
}

bool is_due(const Thread& thread) noexcept {
  return thread.wait.deadline <= present();
}

Thread* first_waiting(bool (*fits)(const Thread&)) noexcept {
  for (Thread* thread = threads().waiting.first(); thread != nullptr; thread = thread->following)
    if (fits(*thread)) return thread;
  return nullptr;
}

/// Makes @p thread go on, if there is one.
bool end_wait_of(Thread* thread, Ended ended) noexcept {
  if (thread != nullptr) make_runnable(*thread, ended);
  return thread != nullptr;
}

bool end_ready_wait() noexcept {
  if (end_wait_of(first_waiting(is_over), Ended::Ready)) return true;
  poll_set.gather(threads().waiting);
  if (poll_set.look() <= 0) return false;
  return end_wait_of(poll_set.first_ready(threads().waiting), Ended::Ready);
}

/// What ended a sleep of the coordinator.
struct Awoken {
  int count;
  int error;
};

Awoken sleep_for_turn(Thread& self, TimeLock& lock, bool looks_for_children) noexcept {
  const timespec moment = timespec_of(kLookForChildren);
  pollfd* const entries = poll_set.with_socket(turn_socket());
  const nfds_t count = poll_set.count_with_socket();
  const int processor = processor_of_turns();
  lock.release();
  Awoken awoken{};
  userbus::begin_stay(self.stay, processor);
  awoken.count = real().ppoll(entries, count, looks_for_children ? &moment : nullptr, open_mask(self));
  awoken.error = awoken.count < 0 ? errno : 0;
  lock.take();
  userbus::end_stay(self.stay);
  return awoken;
}

/// Sleeps until the turn has come, and asks for it when something else comes first. False if the hub has gone.
bool await_turn(Thread& self, TimeLock& lock) noexcept {
  bool wanted = false;
  for (;;) {
    poll_set.clear();
    if (!wanted) poll_set.gather(threads().waiting);
    poll_set.leave_out_bus();
    const bool looks_for_children = !wanted && first_waiting(waits_for_children) != nullptr;
    const Awoken awoken = sleep_for_turn(self, lock, looks_for_children);
    if (awoken.error == EINTR && self.place == Place::Waiting) make_runnable(self, Ended::Signal);
    if (awoken.count > 0 && poll_set.is_socket_ready()) {
      const TurnOutcome outcome = begin_turn(false);
      if (outcome != TurnOutcome::None) return outcome == TurnOutcome::Turn;
      continue;
    }
    const bool child = awoken.count == 0 && has_ended_child();
    if (wanted || (awoken.error == 0 && !child && !poll_set.is_outside_ready())) continue;
    if (child) end_wait_of(first_waiting(waits_for_children), Ended::Ready);
    want_turn();
    wanted = true;
  }
}

/// A sleep that ends with the turn does not let in what signal has come before it.
void let_signals_in(Thread& self, TimeLock& lock) noexcept {
  lock.release();
  const bool taken = take_signals(self);
  lock.take();
  if (taken && self.place == Place::Waiting) make_runnable(self, Ended::Signal);
}

int64_t earliest_instant() noexcept {
  int64_t earliest = first_expiry();
  for (const Thread* thread = threads().waiting.first(); thread != nullptr; thread = thread->following)
    if (thread->wait.deadline < earliest) earliest = thread->wait.deadline;
  return earliest;
}

void lose_hub() noexcept {
  close_hidden(turn_socket());
  use_turn_socket(-1);
  const int64_t offset = wall_time(0);
  go_scaled(1, present(), machine_present(), offset);
  release_all();
}

/// Whether a thread goes on: one that takes a signal in its sleep does so by itself.
bool goes_on() noexcept {
  return threads().running > 0 || (has_turn() && threads().runnable.first() != nullptr);
}

}  // namespace

void coordinate(Thread& self, TimeLock& lock) noexcept {
  bool looked = self.wait.polled && threads().waiting.is_single();
  while (!goes_on()) {
    if (!has_turn()) {
      hold_signals(self);
      if (!await_turn(self, lock)) return lose_hub();
      let_signals_in(self, lock);
      if (take_child_ended()) take_end_of_child(self, lock);
      looked = false;
      continue;
    }
    if (fire_due_timers(self, lock)) looked = false;
    if (goes_on() || (!looked && end_ready_wait())) return;
    if (end_wait_of(first_waiting(is_due), Ended::Deadline)) return;
    looked = true;  // what comes from now on comes by a turn
    const int64_t earliest = earliest_instant();
    if (earliest != kNoInstant && may_go_on_to(earliest)) {
      show_present(earliest);
      continue;
    }
    hold_signals(self);  // as others act from now on
    if (!end_turn(earliest)) return lose_hub();
  }
}

}  // namespace preload
