#pragma once

namespace preload {

/// The one lock of the part that keeps time. Nobody blocks in the kernel or calls the program while holding it. A
/// signal handler that comes while its own thread has it finds it taken.
class TimeLock {
 public:
  TimeLock() noexcept;
  TimeLock(const TimeLock&) = delete;
  TimeLock& operator=(const TimeLock&) = delete;
  ~TimeLock();

  /// For the time of a system call that blocks.
  void release() noexcept;
  void take() noexcept;

  /// Under the lock: @p call is made with @p subject when it is given up, so that who is woken finds it free.
  static void call_later(void (*call)(void*), void* subject) noexcept;

  /// Whether this thread has it already: a signal handler has come in between.
  static bool is_mine() noexcept;
  /// In the only thread of a new process.
  static void forget() noexcept;
};

}  // namespace preload
