#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

#include "device/pdo/pdo_objects.hpp"
#include "libcanopen/base/time.hpp"

namespace device {

/// Received process data that the next frame of the same RPDO overwrites before a cycle has taken them (A08751),
/// and how long ago that was.
class TelegramLoss {
 public:
  /// Without a further loss the alarm ends after this time.
  static constexpr canopen::Duration kClearance = std::chrono::seconds{5};

  /// RPDO @p number (0 for 1400h) has been stored; true if the values before were never taken.
  bool on_rpdo(std::uint16_t number) noexcept {
    const std::uint64_t bit = std::uint64_t{1} << (number / pdo::kStride * pdo::kOfAnAxis + number % pdo::kStride);
    return (std::exchange(waiting_, waiting_ | bit) & bit) != 0;
  }
  /// Whether values wait for a cycle.
  bool is_waiting() const noexcept { return waiting_ != 0; }
  /// A cycle has taken what was received.
  void on_cycle() noexcept { waiting_ = 0; }

  /// Values are lost at @p now; true if that is the first loss of an occurrence.
  bool on_loss(canopen::TimePoint now) noexcept {
    return std::exchange(deadline_, now + kClearance) == canopen::kNever;
  }
  /// When the alarm is over; kNever while there is none.
  canopen::TimePoint deadline() const noexcept { return deadline_; }
  /// Nothing waits, and there is no alarm.
  void clear() noexcept { waiting_ = 0, deadline_ = canopen::kNever; }

 private:
  std::uint64_t waiting_ = 0;  ///< a bit for each RPDO of each axis
  canopen::TimePoint deadline_ = canopen::kNever;
};

}  // namespace device
