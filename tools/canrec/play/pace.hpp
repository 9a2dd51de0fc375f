#pragma once

#include <algorithm>
#include <chrono>

#include "libcanopen/base/time.hpp"

namespace canrec {

/// When the frames of a log are due that is played: as far behind the first one as in the log, divided by a speed.
/// Every time is reckoned from the beginning, so nothing adds up.
class Pace {
 public:
  /// @p speed: so many times as fast as it was, above 0; 0: without waiting.
  explicit Pace(double speed) noexcept : speed_{speed} {}

  [[nodiscard]] bool waits() const noexcept { return speed_ > 0.0; }
  /// Begins at @p now with the frame of time stamp @p first.
  void begin(std::chrono::nanoseconds first, canopen::TimePoint now) noexcept {
    first_ = first;
    begin_ = now;
    due_ = now;
  }
  /// When the frame of time stamp @p at is due, which is not before the frame in front of it.
  [[nodiscard]] canopen::TimePoint due(std::chrono::nanoseconds at) noexcept {
    const std::chrono::duration<double, std::nano> behind{static_cast<double>((at - first_).count()) / speed_};
    due_ = std::max(due_, begin_ + std::chrono::duration_cast<canopen::Duration>(behind));
    return due_;
  }

 private:
  double speed_;
  std::chrono::nanoseconds first_{};
  canopen::TimePoint begin_{};
  canopen::TimePoint due_{};
};

}  // namespace canrec
