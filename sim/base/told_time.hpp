#pragma once

#include "libcanopen/base/time.hpp"
#include "os/clock.hpp"

namespace sim {

/// The time of a simulated world, which stands while anybody in it acts. The process lives by it (os::use_time()).
class ToldTime final : public os::OtherTime {
 public:
  /// What it shows at first: always the same, so that runs can be compared.
  static constexpr canopen::TimePoint kBegin{std::chrono::seconds{1000}};
  /// CLOCK_REALTIME then: 1 January 2025, 0:00 UTC.
  static constexpr std::chrono::nanoseconds kWallBegin = std::chrono::seconds{1'735'689'600};

  /// The present is @p now.
  void set(canopen::TimePoint now) noexcept { now_ = now; }
  [[nodiscard]] canopen::TimePoint now() const noexcept { return now_; }

  [[nodiscard]] std::chrono::nanoseconds monotonic() const noexcept override { return now_.time_since_epoch(); }
  [[nodiscard]] std::chrono::nanoseconds wall() const noexcept override { return kWallBegin + (now_ - kBegin); }
  [[nodiscard]] bool stands_while_acting() const noexcept override { return true; }
  void wait_readable(int) noexcept override {}
  void note_sent() noexcept override {}
  void note_touched() noexcept override {}
  void note_handed_over() noexcept override {}

 private:
  canopen::TimePoint now_ = kBegin;
};

}  // namespace sim
