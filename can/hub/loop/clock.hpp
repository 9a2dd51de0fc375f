#pragma once

#include <chrono>
#include <cstdint>

#include "can/userbus/time.hpp"
#include "libcanopen/base/time.hpp"
#include "os/clock.hpp"

namespace hub {

/// The present on the time line of the machine.
inline canopen::TimePoint monotonic_now() noexcept {
  return canopen::TimePoint{os::monotonic_time()};
}

/// The clock of the bus, on whose time line everything in the hub is that has to do with frames. What has to do
/// with the machine (who waits for whom, and how long) is on that of monotonic_now().
class Clock {
 public:
  /// The machine's.
  Clock() = default;
  /// As @p wish says.
  explicit Clock(const userbus::TimeWish& wish) noexcept;

  [[nodiscard]] userbus::TimeMode mode() const noexcept { return mode_; }
  [[nodiscard]] double scale() const noexcept { return scale_; }
  /// True in virtual and stepped time: set() tells what it is.
  [[nodiscard]] bool is_told() const noexcept { return is_told_; }
  /// The present.
  [[nodiscard]] canopen::TimePoint now() const noexcept {
    return mode_ == userbus::TimeMode::Real ? monotonic_now() : other_now();
  }
  /// @p time of this clock on CLOCK_REALTIME of the bus (ns).
  [[nodiscard]] std::int64_t wall(canopen::TimePoint time) const noexcept {
    return time.time_since_epoch().count() + wall_offset();
  }
  /// The present on CLOCK_REALTIME of the bus (ns).
  [[nodiscard]] std::int64_t wall() const noexcept {
    return mode_ == userbus::TimeMode::Real ? machine_wall() : other_wall();
  }
  /// When @p time of this clock is on that of the machine, kNever for kNever; not where it is told.
  [[nodiscard]] canopen::TimePoint machine_time(canopen::TimePoint time) const noexcept {
    return mode_ == userbus::TimeMode::Real || time == canopen::kNever ? time : unscaled(time);
  }
  /// The present where it is told, else @p otherwise.
  [[nodiscard]] canopen::TimePoint told_or(canopen::TimePoint otherwise) const noexcept {
    return is_told_ ? now_ : otherwise;
  }
  /// The present is @p now, which is not before what it was; where it is told.
  void set(canopen::TimePoint now) noexcept { now_ = now; }

  /// What is the first instant of a clock that is not the machine's, and what the machine's showed then.
  [[nodiscard]] canopen::TimePoint begin() const noexcept { return begin_; }
  [[nodiscard]] canopen::TimePoint machine_begin() const noexcept { return machine_begin_; }
  /// CLOCK_REALTIME less this clock (ns).
  [[nodiscard]] std::int64_t wall_offset() const noexcept;

 private:
  [[nodiscard]] canopen::TimePoint other_now() const noexcept;
  [[nodiscard]] std::int64_t other_wall() const noexcept;
  [[nodiscard]] static std::int64_t machine_wall() noexcept {
    return std::chrono::nanoseconds{std::chrono::system_clock::now().time_since_epoch()}.count();
  }
  [[nodiscard]] canopen::TimePoint unscaled(canopen::TimePoint time) const noexcept;

  userbus::TimeMode mode_ = userbus::TimeMode::Real;
  bool is_told_ = false;
  double scale_ = 1;
  canopen::TimePoint begin_{};
  canopen::TimePoint machine_begin_{};
  canopen::TimePoint now_{};
  std::int64_t wall_offset_ = 0;
};

/// The clock of a bus that has the machine's time.
inline const Clock kMachineClock{};

}  // namespace hub
