#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>

#include <poll.h>
#include <pthread.h>

#include "can/preload/time/base/instant.hpp"

namespace preload {

/// What a thread waits for: whichever comes first.
struct Wait {
  const pollfd* descriptors = nullptr;
  nfds_t count = 0;
  int64_t deadline = kNoInstant;           ///< of the bus's CLOCK_MONOTONIC
  const void* address = nullptr;           ///< what wake() is called with
  uint32_t bits = UINT32_MAX;              ///< one of which is among those of wake()
  const sigset_t* mask = nullptr;          ///< signals that are blocked meanwhile, if others than otherwise
  bool for_children = false;               ///< the end of a child
  bool (*is_over)(const void*) = nullptr;  ///< asked with `subject`, without a system call
  const void* subject = nullptr;
  bool polled = false;  ///< the descriptors were not ready just now
};

/// How a wait has ended; Gone: the hub, time goes by the machine from now on.
enum class Ended : uint8_t { Ready, Deadline, Signal, Gone };

/// Where a thread is.
enum class Place : uint8_t {
  Free,      ///< there is no such thread
  Running,   ///< in the program
  Waiting,   ///< for something to happen
  Runnable,  ///< it has happened; it goes on when the one before it waits
};

/// What those that come next have seen of a running thread.
struct Patience {
  int64_t processor_ns = -1;  ///< processor time that it had used when it was first looked at
  int blocked = 0;            ///< how often in a row it was asleep
};

/// A thread of the program that is known.
struct Thread {
  static constexpr int kNoBell = -1;
  static constexpr int kNoBellToBeHad = -2;

  Thread* previous;  ///< in the list of its place
  Thread* following;
  Place place;
  Ended ended;
  pthread_t handle;
  std::atomic<int> id;  ///< of the kernel; 0 as long as it has not begun
  std::atomic<int> go;  ///< the thread sleeps while it is 0
  int bell;             ///< descriptor by which it is woken, kNoBell or kNoBellToBeHad
  bool holds_signals;
  sigset_t mask_before;  ///< while it does
  int cancel_state;      ///< of the program, while the thread waits
  Patience patience;
  Wait wait;
};

/// Threads in the order in which they came.
class ThreadList {
 public:
  [[nodiscard]] Thread* first() const noexcept { return first_; }
  [[nodiscard]] bool is_single() const noexcept { return first_ != nullptr && first_ == last_; }
  void append(Thread& thread) noexcept;
  void remove(Thread& thread) noexcept;

 private:
  Thread* first_ = nullptr;
  Thread* last_ = nullptr;
};

/// A new thread, under the TimeLock; nullptr if there is no memory.
Thread* new_thread() noexcept;
/// Gives back its memory.
void free_thread(Thread& thread) noexcept;
/// Calls @p visit with @p argument for each thread that there is.
void for_each_thread(void (*visit)(Thread&, void*), void* argument) noexcept;

/// The calling thread; nullptr if it is not known.
Thread* own_thread() noexcept;
void set_own_thread(Thread* thread) noexcept;

}  // namespace preload
