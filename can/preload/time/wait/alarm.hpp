#pragma once

#include "can/preload/time/wait/timer.hpp"

namespace preload {

/// Lets signals come that @p mask does not block: whether a handler has run.
bool is_signal_taken(const sigset_t& mask) noexcept;

/// Does @p act with all signals blocked, and lets come then what @p mask (nullptr: the present one) lets come:
/// whether a handler has run in this thread.
template <class Act>
bool do_and_take_signals(Act act, const sigset_t* mask) noexcept {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  act();
  const bool taken = is_signal_taken(mask != nullptr ? *mask : before);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return taken;
}

/// Signal @p number has been sent: it ends the wait of @p self if that has @p taken it, else that of the thread
/// that takes it, which is waited for.
void settle_signal(int number, bool taken, Thread& self, TimeLock& lock) noexcept;

/// Does what @p timer, which has expired, does but for a descriptor: a signal, or a function in a thread of its
/// own. The signal ends the wait of @p self, which coordinates, if it comes to that.
void raise_alarm(const BusTimer& timer, Thread& self, TimeLock& lock) noexcept;

}  // namespace preload
