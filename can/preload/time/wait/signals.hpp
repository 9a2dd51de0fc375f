#pragma once

#include <csignal>

#include "can/preload/time/wait/thread.hpp"

namespace preload {

// A signal that comes while a thread waits ends its wait, even if it comes before the thread has gone to sleep: so
// signals are blocked from when others may act, and come in the sleeps themselves.

/// Blocks all signals in the calling thread.
void hold_signals(Thread& self) noexcept;
/// Lets them come as before; not under the TimeLock, as handlers run here.
void release_signals(Thread& self) noexcept;

/// Signals that are blocked in the sleeps of @p self; nullptr: as they are.
inline const sigset_t* open_mask(const Thread& self) noexcept {
  if (self.wait.mask != nullptr) return self.wait.mask;
  return self.holds_signals ? &self.mask_before : nullptr;
}

/// Lets signals come as in a sleep of @p self, which holds them: whether a handler has run.
bool take_signals(const Thread& self) noexcept;

/// Sleeps until call_thread() or for @p limit (nullptr: no limit) of the machine's time. An errno: EINTR,
/// ETIMEDOUT, or 0.
int sleep_until_called(Thread& self, const timespec* limit) noexcept;
/// Ends the sleep of @p thread, or the next one, which then sees @p word in its `go`. Under the TimeLock, and done
/// when that is given up.
void call_thread(Thread& thread, int word) noexcept;

}  // namespace preload
