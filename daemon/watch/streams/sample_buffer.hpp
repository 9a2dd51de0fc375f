#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "daemon/watch/streams/ring_places.hpp"
#include "libcanopen/base/time.hpp"

namespace axisd {

/// Samples of signals on their way from the thread of a unit to that of the control socket. What does not fit is
/// counted and lost.
class SampleBuffer {
 public:
  /// What is sampled.
  struct Plan {
    std::vector<std::string> signals;  ///< names
    canopen::Duration period{};        ///< from one sample to the next, greater than 0
  };

  /// With room for @p room samples. Allocates.
  SampleBuffer(Plan plan, std::size_t room)
      : plan_{std::move(plan)}, times_(room), values_(room * plan_.signals.size()), places_{room} {}

  [[nodiscard]] const Plan& plan() const noexcept { return plan_; }
  [[nodiscard]] std::size_t width() const noexcept { return plan_.signals.size(); }

  // The thread of the unit.
  /// Where the values of a sample at @p time, since the start of the unit, are to be put before publish(); empty
  /// if there is no room, which is counted.
  [[nodiscard]] std::span<double> next(canopen::Duration time) noexcept {
    if (places_.is_full()) {
      miss(1);
      return {};
    }
    times_[places_.next()] = time;
    return std::span{values_}.subspan(places_.next() * width(), width());
  }
  void publish() noexcept { places_.publish(); }
  /// So many samples could not be taken.
  void miss(std::uint64_t count) noexcept { lost_.fetch_add(count, std::memory_order_relaxed); }

  // The thread of the control socket.
  [[nodiscard]] std::size_t waiting() const noexcept { return places_.waiting(); }
  /// Of the @p number-th sample that waits, from 0 on.
  [[nodiscard]] canopen::Duration time(std::size_t number) const noexcept { return times_[places_.at(number)]; }
  [[nodiscard]] double value(std::size_t number, std::size_t signal) const noexcept {
    return values_[places_.at(number) * width() + signal];
  }
  void release(std::size_t count) noexcept { places_.release(count); }
  /// How many were lost since the last call.
  [[nodiscard]] std::uint64_t take_lost() noexcept { return lost_.exchange(0, std::memory_order_relaxed); }

 private:
  Plan plan_;
  std::vector<canopen::Duration> times_;
  std::vector<double> values_;  ///< a sample after the other
  RingPlaces places_;
  std::atomic<std::uint64_t> lost_ = 0;
};

}  // namespace axisd
