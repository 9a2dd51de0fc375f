#pragma once

#include "libcanopen/base/time.hpp"
#include "os/timer.hpp"

namespace axisd {

/// When the loop is to be woken: a timer that is set only when it has to ring earlier than it would anyway.
class WakeUp {
 public:
  /// Makes descriptor() readable at @p when at the latest; it is @p now. A later time than the one already set is
  /// taken up when that one has passed: moving a deadline away costs no system call.
  void by(canopen::TimePoint when, canopen::TimePoint now) noexcept {
    if (when < set_ || has_rung(now)) set(when);
  }
  /// True if the time set has come: descriptor() is readable until the next by().
  bool has_rung(canopen::TimePoint now) const noexcept { return set_ <= now; }
  int descriptor() const noexcept { return timer_.descriptor(); }

 private:
  /// Setting the timer also takes back that it has rung, so that nobody has to read it.
  void set(canopen::TimePoint when) noexcept {
    set_ = when;
    when == canopen::kNever ? timer_.stop() : timer_.ring_at(when.time_since_epoch());
  }

  os::Timer timer_;
  canopen::TimePoint set_ = canopen::kNever;
};

}  // namespace axisd
