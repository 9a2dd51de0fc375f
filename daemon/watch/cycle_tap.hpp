#pragma once

#include "daemon/watch/listeners.hpp"
#include "unit/runner.hpp"

namespace axisd {

/// Lets several look at the cycles of a unit, which knows one observer. While nobody does, nobody is in the way.
class CycleTap final : private unit::CycleObserver {
 public:
  /// @p runner outlives this.
  explicit CycleTap(unit::Runner& runner) noexcept : runner_{runner} {}
  ~CycleTap() override = default;
  CycleTap(const CycleTap&) = delete;
  CycleTap& operator=(const CycleTap&) = delete;

  /// False if there are too many observers. Neither from within a call to an observer.
  [[nodiscard]] bool add(unit::CycleObserver& observer) noexcept {
    const bool added = observers_.add(observer);
    connect();
    return added;
  }
  void remove(unit::CycleObserver& observer) noexcept {
    observers_.remove(observer);
    connect();
  }

 private:
  void on_cycle_begin(unit::TimePoint begin) noexcept override {
    for (unit::CycleObserver* const each : observers_.all()) each->on_cycle_begin(begin);
  }
  void on_step(long step) noexcept override {
    for (unit::CycleObserver* const each : observers_.all()) each->on_step(step);
  }
  void on_cycle_end() noexcept override {
    for (unit::CycleObserver* const each : observers_.all()) each->on_cycle_end();
  }
  /// One alone needs nobody to tell it.
  void connect() noexcept {
    const auto all = observers_.all();
    runner_.observe(all.empty() ? nullptr : all.size() == 1 ? all.front() : this);
  }

  unit::Runner& runner_;
  Listeners<unit::CycleObserver> observers_;
};

}  // namespace axisd
