#pragma once

#include <chrono>
#include <cstdint>

#include <systemd/sd-daemon.h>

#include "libcanopen/base/time.hpp"

namespace axisd {

/// Feeds the watchdog of systemd, if it asks for that, from where the loop has told the time to the unit: a
/// program that serves requests and runs no cycles is not alive.
class Watchdog {
 public:
  Watchdog() noexcept {
    std::uint64_t microseconds = 0;
    if (sd_watchdog_enabled(0, &microseconds) <= 0) return;
    period_ = std::chrono::microseconds{microseconds} / 2;  // as sd_watchdog_enabled(3) recommends
    due_ = canopen::TimePoint{};
  }

  /// When on_time() is wanted next; kNever if nobody watches.
  canopen::TimePoint due() const noexcept { return due_; }
  /// What was due at @p now has been done.
  void on_time(canopen::TimePoint now) noexcept {
    if (now < due_) return;
    sd_notify(0, "WATCHDOG=1");
    due_ = now + period_;
  }

 private:
  canopen::Duration period_{};
  canopen::TimePoint due_ = canopen::kNever;
};

}  // namespace axisd
