#pragma once

#include <cstdint>

#include "can/preload/time/wait/thread.hpp"

namespace preload {

// What the wrapped calls of a process that lives by turns do in place of blocking.

/// Waits; other threads and other processes go on meanwhile, and time does when all of them wait. Ended::Gone,
/// too, where it cannot be waited: in a signal handler that has come while its own thread waits.
Ended wait_for(const Wait& wait) noexcept;
/// The same for who is woken by wake(): @p is_done is asked with @p argument when that counts already, and the
/// wait does not begin if it says so.
Ended wait_unless(const Wait& wait, bool (*is_done)(void*), void* argument) noexcept;
/// Ends the wait of thread @p handle, which is being cancelled.
void interrupt(pthread_t handle) noexcept;

/// Ends waits for @p address that have one of @p bits, @p most of them, in the order in which they began. Returns
/// their number. May be called in a signal handler.
int wake(const void* address, int most, uint32_t bits = UINT32_MAX) noexcept;
/// The same under the TimeLock.
int wake_waiting(const void* address, int most, uint32_t bits) noexcept;

/// The program has looked at the clock, or whether something has come, without waiting. One that does nothing else
/// gets some time now and then, so that it comes to an end.
void note_idle() noexcept;
/// The program has polled, and goes on at once. Now and then others of its threads that can go on do: it may poll
/// for what one of them is about to do.
void note_poll() noexcept;
/// Other threads that can go on do; counts as such a look.
void let_others_go() noexcept;

}  // namespace preload
