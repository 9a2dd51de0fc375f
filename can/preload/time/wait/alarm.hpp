#pragma once

#include "can/preload/time/wait/signals.hpp"
#include "can/preload/time/wait/timer.hpp"

namespace preload {

/// Does @p act with all signals held by @p self, the calling thread, and lets come then what is open in its wait:
/// whether a handler has run in it. They stay held.
template <class Act>
bool do_and_take_signals(Act act, Thread& self) noexcept {
  hold_signals(self);
  act();
  return take_signals(self);
}

/// Signal @p number has been sent: it ends the wait of @p self if that has @p taken it, else that of the thread
/// that takes it, which is waited for. @p interruptions: Threads::interruptions before it was sent.
void settle_signal(int number, bool taken, unsigned interruptions, Thread& self, TimeLock& lock) noexcept;

/// Does what @p timer, which has expired, does but for a descriptor: a signal, or a function in a thread of its
/// own. The signal ends the wait of @p self, which coordinates, if it comes to that.
void raise_alarm(const BusTimer& timer, Thread& self, TimeLock& lock) noexcept;

}  // namespace preload
