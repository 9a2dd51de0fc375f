#pragma once

#include <cstdint>

#include "can/preload/time/base/lock.hpp"
#include "can/preload/time/wait/thread.hpp"

namespace preload {

// Threads of a process that lives by turns run one after the other: one that something has happened to goes on
// when the one before it waits. So a program does the same in each run. When all wait, the last one asks for what
// is next (coordinate()). Under the TimeLock all of it.

/// The threads of the process by what they do.
struct Threads {
  ThreadList waiting;
  ThreadList runnable;
  int running = 0;
  int watchmen = 0;                     ///< who sleep and look every while whether those that run let others go on
  unsigned interruptions = 0;           ///< how many waits signals have ended
  const Thread* coordinator = nullptr;  ///< which of those that wait looks for what is next
};
Threads& threads() noexcept;

/// The calling thread, which is made known if it was not.
Thread& this_thread() noexcept;

/// Makes @p thread, which waits, go on when it is its turn.
void make_runnable(Thread& thread, Ended ended) noexcept;
/// Lets the next runnable thread go.
void release_first() noexcept;
/// Everybody goes on: there are no turns any more.
void release_all() noexcept;

/// Begins the wait of @p self, which still runs; what comes from now on ends it.
void begin_wait(Thread& self, const Wait& wait) noexcept;
/// Ends it before finish_wait().
void cancel_wait(Thread& self) noexcept;
/// How many waits there are that wake() may end; without the TimeLock.
int count_waits_for_addresses() noexcept;
/// Sleeps until the wait has ended.
Ended finish_wait(Thread& self, TimeLock& lock) noexcept;

/// The calling thread, in a signal handler, jumps out of its wait: that is over. Sleeps until it may go on.
void abandon_wait() noexcept;

/// Looks for what is next while all threads wait, until one may go on. @p self does it for them.
void coordinate(Thread& self, TimeLock& lock) noexcept;

/// A thread of its own for the next pthread_create(3), runnable; nullptr if there is no memory.
Thread* announce_thread() noexcept;
/// That thread has begun: it sleeps until it is its turn.
void begin_thread(Thread& self) noexcept;
/// The calling thread ends, or @p thread has never begun.
void end_thread(Thread& thread) noexcept;
/// In a new process: the calling thread is the only one.
void forget_other_threads() noexcept;

}  // namespace preload
