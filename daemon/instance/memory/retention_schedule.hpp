#pragma once

#include <algorithm>
#include <chrono>

#include "libcanopen/base/time.hpp"

namespace axisd {

/// When what the unit keeps through a power cut is to be written while it runs: soon after the faults have
/// changed, now and then while something moves, never if neither is the case.
class RetentionSchedule {
 public:
  /// From one write to the next one because of faults.
  static constexpr canopen::Duration kShortest = std::chrono::seconds{1};
  /// From the beginning of a movement to the write, and from a failed write to the next one.
  static constexpr canopen::Duration kPeriod = std::chrono::seconds{60};

  /// A fault has come or gone.
  void on_faults(canopen::TimePoint now) noexcept { due_ = std::min(due_, std::max(now, earliest_)); }
  /// Something moves.
  void on_motion(canopen::TimePoint now) noexcept { due_ = std::min(due_, now + kPeriod); }
  /// A write was tried.
  void on_write(bool done, canopen::TimePoint now) noexcept {
    earliest_ = now + (done ? kShortest : kPeriod);
    due_ = done ? canopen::kNever : earliest_;
  }

  /// When to write; kNever: nothing has changed since.
  canopen::TimePoint due() const noexcept { return due_; }

 private:
  canopen::TimePoint earliest_{};
  canopen::TimePoint due_ = canopen::kNever;
};

}  // namespace axisd
