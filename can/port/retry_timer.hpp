#pragma once

#include <chrono>

#include "os/timer.hpp"

namespace bus {

/// Rings when a lost bus is to be tried again: after 100 ms, then after twice as long each time, up to a second.
class RetryTimer {
 public:
  static constexpr std::chrono::milliseconds kFirst{100};
  static constexpr std::chrono::milliseconds kLongest{1000};

  /// Polls readable when it has rung.
  [[nodiscard]] int descriptor() const noexcept { return timer_.descriptor(); }
  /// Rings after the shortest time.
  void start() noexcept;
  /// Rings again, later than the last time.
  void start_later() noexcept;
  /// Rings after @p patience: the time that one attempt may take.
  void limit(std::chrono::nanoseconds patience) noexcept { timer_.ring_after(patience); }
  /// Does not ring.
  void stop() noexcept { timer_.stop(); }
  /// True, once, if it has rung.
  [[nodiscard]] bool take() noexcept { return timer_.take(); }

 private:
  os::Timer timer_;
  std::chrono::milliseconds wait_ = kFirst;
};

}  // namespace bus
