#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>

#include <poll.h>
#include <pthread.h>

#include "can/preload/time/base/instant.hpp"
#include "can/userbus/processor.hpp"

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
  int64_t looked_ns = 0;      ///< when it was looked at whether it is asleep, by the machine's clock
  int blocked = 0;            ///< how often in a row it was
};

/// A thread of the program that is known.
struct Thread {
  static constexpr int kNoBell = 0;
  static constexpr int kNoBellToBeHad = -1;

  Thread* previous = nullptr;  ///< in the list of its place
  Thread* following = nullptr;
  Place place = Place::Free;
  Ended ended = Ended::Ready;
  pthread_t handle = 0;
  std::atomic<int> id = 0;          ///< of the kernel; 0 as long as it has not begun
  std::atomic<int> go = 0;          ///< the thread sleeps while it is 0
  std::atomic<int> bell = kNoBell;  ///< descriptor by which it is woken, or none; the next thread here has it
  bool has_stopped = false;  ///< it is in a wait, and none of those that run unless it has been released since
  bool watches = false;      ///< it sleeps as a watchman
  bool holds_signals = false;
  sigset_t mask_before{};  ///< while it does
  int cancel_state = 0;    ///< of the program, while the thread waits
  Patience patience;
  Wait wait;
  userbus::Stay stay;  ///< while it sleeps
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
/// In a new process: those of its parent but @p self are none of its threads, and their bells not its own.
void forget_threads_but(const Thread* self) noexcept;
/// Calls @p visit with @p argument for each thread that there is.
void for_each_thread(void (*visit)(Thread&, void*), void* argument) noexcept;

/// The calling thread; nullptr if it is not known.
Thread* own_thread() noexcept;
void set_own_thread(Thread* thread) noexcept;

}  // namespace preload
