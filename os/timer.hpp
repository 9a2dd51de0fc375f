#pragma once

#include <chrono>

#include "os/descriptor.hpp"

namespace os {

/// One timerfd on CLOCK_MONOTONIC. Every setting takes the one before back, and what has rung with it.
class Timer {
 public:
  /// Throws std::system_error if the kernel gives no timer.
  Timer();

  /// Readable when it has rung, until take() or the next setting.
  [[nodiscard]] int descriptor() const noexcept { return timer_.get(); }
  /// Rings at @p since_zero of the clock (os::monotonic_time()); at once if that has passed.
  void ring_at(std::chrono::nanoseconds since_zero) noexcept;
  /// Rings @p wait from now, more than zero.
  void ring_after(std::chrono::nanoseconds wait) noexcept { set(0, wait); }
  /// Does not ring.
  void stop() noexcept { set(0, std::chrono::nanoseconds{0}); }
  /// True, once, if it has rung.
  [[nodiscard]] bool take() noexcept;

 private:
  void set(int flags, std::chrono::nanoseconds value) noexcept;

  Descriptor timer_;
};

}  // namespace os
