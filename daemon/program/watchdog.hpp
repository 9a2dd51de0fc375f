#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

#include <systemd/sd-daemon.h>

#include "daemon/fleet/fleet.hpp"
#include "libcanopen/base/time.hpp"

namespace axisd {

/// Feeds the watchdog of systemd, if it asks for that, when every loop has told the time to its units: a program
/// that serves requests and runs no cycles is not alive.
class Watchdog {
 public:
  /// Of the loops of @p fleet, which outlives it.
  explicit Watchdog(Fleet& fleet) noexcept : fleet_{fleet} {
    std::uint64_t microseconds = 0;
    if (sd_watchdog_enabled(0, &microseconds) <= 0) return;
    period_ = std::chrono::microseconds{microseconds} / 2;  // as sd_watchdog_enabled(3) recommends
    due_ = canopen::TimePoint{};
  }

  /// When on_time() is wanted next; kNever if nobody watches.
  canopen::TimePoint due() const noexcept { return due_; }
  /// It is @p now: asks the loops if they live. The last that does feeds the watchdog; one that does not keeps it
  /// hungry.
  void on_time(canopen::TimePoint now) {
    if (now < due_) return;
    due_ = now + period_;
    if (silent_.load() != 0) return;
    silent_.store(fleet_.loops().size());
    for (UnitLoop& loop : fleet_.loops())
      loop.post([this] {
        if (silent_.fetch_sub(1) == 1) sd_notify(0, "WATCHDOG=1");
      });
  }

 private:
  Fleet& fleet_;
  canopen::Duration period_{};
  canopen::TimePoint due_ = canopen::kNever;
  std::atomic<std::size_t> silent_{0};  ///< loops that have not answered
};

}  // namespace axisd
