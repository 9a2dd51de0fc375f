#pragma once

#include "bus/descriptor.hpp"
#include "libcanopen/base/time.hpp"

namespace axisd {

/// One absolute timerfd on CLOCK_MONOTONIC, set only when it has to ring earlier than it would anyway.
class Timer {
 public:
  /// Throws std::system_error if the kernel gives no timer.
  Timer();

  /// Makes descriptor() readable at @p when at the latest. A later time than the one already set is taken up when
  /// that one has passed: moving a deadline away costs no system call.
  void wake_by(canopen::TimePoint when) noexcept;
  /// Has rung: takes the expiration back so that the descriptor is quiet again.
  void acknowledge() noexcept;
  int descriptor() const noexcept { return descriptor_.get(); }

 private:
  bus::Descriptor descriptor_;
  canopen::TimePoint set_ = canopen::kNever;
};

}  // namespace axisd
