#include "can/preload/time/wait/children.hpp"

#include <atomic>

#include "can/preload/time/base/real.hpp"
#include "can/preload/time/wait/alarm.hpp"
#include "can/preload/time/wait/scheduler.hpp"

namespace preload {

namespace {

/// Children that the program has waited for and of which the hub has not told yet.
std::atomic<int> reaped;

/// The hub tells when the sockets of a child are closed, which is a little before it can be waited for.
void await_ended_child() noexcept {
  constexpr int kMostLooks = 250;
  const timespec moment{.tv_sec = 0, .tv_nsec = kNsOfMillisecond};
  for (int i = 0; i < kMostLooks && reaped == 0 && !has_ended_child(); ++i) real().nanosleep(&moment, nullptr);
}

void end_waits_for_children() noexcept {
  for (Thread* thread = threads().waiting.first(); thread != nullptr;) {
    Thread* const following = thread->following;
    if (thread->wait.for_children) make_runnable(*thread, Ended::Ready);
    thread = following;
  }
}

}  // namespace

bool has_ended_child() noexcept {
  siginfo_t info{};
  const int outcome = real().waitid(P_ALL, 0, &info, WEXITED | WSTOPPED | WCONTINUED | WNOHANG | WNOWAIT);
  return outcome != 0 || info.si_pid != 0;
}

void note_reaped() noexcept {
  ++reaped;
}

void take_end_of_child(Thread& self, TimeLock& lock) noexcept {
  const unsigned interruptions = threads().interruptions;
  lock.release();
  const bool taken = do_and_take_signals(await_ended_child, self);
  lock.take();
  reaped = 0;
  end_waits_for_children();
  settle_signal(SIGCHLD, taken, interruptions, self, lock);
}

}  // namespace preload
