#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "drive/axis/axis.hpp"
#include "drive/step_observer.hpp"
#include "unit/time.hpp"

namespace unit {

/// When process-data cycles (p8848) are due: on a grid from power-on, also after a rest.
class CycleClock {
 public:
  static constexpr Duration kFactory = std::chrono::milliseconds{4};
  /// Time that missed cycles are made up for; what is beyond is skipped.
  static constexpr Duration kMostAtOnce = std::chrono::milliseconds{100};

  /// Cycles that are due at once.
  struct Due {
    std::int64_t run;
    std::int64_t skipped;
  };

  /// p8848 as a time: whole control periods, at least one.
  static Duration period_of(double milliseconds) noexcept {
    constexpr auto kStep = std::chrono::round<Duration>(std::chrono::duration<double>{motor::kControlPeriod});
    const double steps = milliseconds * 1e6 / static_cast<double>(kStep.count());
    return std::max(std::int64_t{1}, static_cast<std::int64_t>(std::llround(steps))) * kStep;
  }

  /// Cycles that were taken to be run.
  std::uint64_t run() const noexcept { return run_; }

  /// Power-on: the first cycle begins.
  void begin(TimePoint now) noexcept { last_ = now; }
  /// The next cycle ends @p period after the last one.
  void set_period(Duration period) noexcept { period_ = period; }
  Duration period() const noexcept { return period_; }
  double seconds() const noexcept { return std::chrono::duration<double>{period_}.count(); }
  /// Where the grid has the end of the last cycle and the beginning of the next one.
  TimePoint last() const noexcept { return last_; }

  bool is_resting() const noexcept { return resting_; }
  /// When the next cycle ends; kNever while resting.
  TimePoint next() const noexcept { return resting_ ? kNever : last_ + period_; }
  /// Nothing moves: no cycle is due until wake().
  void rest() noexcept { resting_ = true; }
  /// The cycle that @p time lies in is to be run, the first one after the rest at the earliest.
  void wake(TimePoint time) noexcept {
    if (!resting_) return;
    resting_ = false;
    if (time > last_) last_ += (time - last_) / period_ * period_;
  }
  /// The cycles that have ended by @p now; from then on it counts anew.
  Due take_due(TimePoint now) noexcept {
    const std::int64_t due = (now - last_) / period_;
    const std::int64_t run = std::min(due, kMostAtOnce / period_);
    last_ += due * period_;
    run_ += static_cast<std::uint64_t>(run);
    return {run, due - run};
  }
  /// The first one of them that is to be run; it counts on from there.
  Due take_first_due(TimePoint now) noexcept {
    const std::int64_t due = resting_ ? 0 : (now - last_) / period_;
    if (due <= 0) return {0, 0};
    const std::int64_t skipped = std::max(std::int64_t{0}, due - std::max(kMostAtOnce / period_, std::int64_t{1}));
    last_ += (skipped + 1) * period_;
    ++run_;
    return {1, skipped};
  }

 private:
  Duration period_ = kFactory;
  TimePoint last_{};  ///< end of the last cycle
  bool resting_ = true;
  std::uint64_t run_ = 0;
};

/// Looks at a drive unit while it runs its cycles, with the time that they have on the grid: a cycle that is made
/// up for late has the time that it should have had.
class CycleObserver : public drive::StepObserver {
 public:
  /// A cycle begins, at @p begin on the grid; the values are still those of the end of the last one.
  virtual void on_cycle_begin(TimePoint begin) noexcept = 0;
};

}  // namespace unit
