#pragma once

#include <chrono>

#include "can/port/descriptor.hpp"

namespace bus {

/// Rings when a lost bus is to be tried again: after 100 ms, then after twice as long each time, up to a second.
class RetryTimer {
 public:
  static constexpr std::chrono::milliseconds kFirst{100};
  static constexpr std::chrono::milliseconds kLongest{1000};

  /// Throws std::system_error if the kernel gives no timer.
  RetryTimer();

  /// Polls readable when it has rung.
  [[nodiscard]] int descriptor() const noexcept { return timer_.get(); }
  /// Rings after the shortest time.
  void start() noexcept;
  /// Rings again, later than the last time.
  void start_later() noexcept;
  /// Rings after @p patience: the time that one attempt may take.
  void limit(std::chrono::milliseconds patience) noexcept { set(patience); }
  /// Does not ring.
  void stop() noexcept { set(std::chrono::milliseconds{0}); }
  /// True, once, if it has rung.
  [[nodiscard]] bool take() noexcept;

 private:
  void set(std::chrono::milliseconds wait) noexcept;

  Descriptor timer_;
  std::chrono::milliseconds wait_ = kFirst;
};

}  // namespace bus
