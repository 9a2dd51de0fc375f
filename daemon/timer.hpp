#pragma once

#include "can/port/descriptor.hpp"
#include "libcanopen/base/time.hpp"

namespace axisd {

/// One absolute timerfd on CLOCK_MONOTONIC, set only when it has to ring earlier than it would anyway.
class Timer {
 public:
  /// Throws std::system_error if the kernel gives no timer.
  Timer();

  /// Makes descriptor() readable at @p when at the latest; it is @p now. A later time than the one already set is
  /// taken up when that one has passed: moving a deadline away costs no system call.
  void wake_by(canopen::TimePoint when, canopen::TimePoint now) noexcept {
    if (when < set_ || has_rung(now)) set(when);
  }
  /// True if the time set has come: descriptor() is readable until the next wake_by().
  bool has_rung(canopen::TimePoint now) const noexcept { return set_ <= now; }
  int descriptor() const noexcept { return descriptor_.get(); }

 private:
  void set(canopen::TimePoint when) noexcept;

  bus::Descriptor descriptor_;
  canopen::TimePoint set_ = canopen::kNever;
};

}  // namespace axisd
