#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "cia402/base/demand.hpp"
#include "cia402/modes/cyclic/cyclic_settings.hpp"

namespace cia402 {

using namespace std::chrono_literals;

/// Time in cycles of 1 ms from 0 on, for a mode that is told instants within the running cycle.
class Timeline {
 public:
  /// @p cycle is called at the end of each cycle, and gives back the demand there.
  explicit Timeline(std::function<Demand()> cycle) : cycle_{std::move(cycle)} {}

  /// All cycles that end at @p time or before.
  void run_to(TimeNs time) {
    while (now_ + kCycleTime <= time) {
      demands_.push_back(cycle_());
      now_ += kCycleTime;
    }
  }
  /// The same, and the instant of @p time in the running cycle.
  TimeNs instant(TimeNs time) {
    run_to(time);
    return time - now_;
  }
  TimeNs now() const { return now_; }
  /// At the end of the cycle that ended at @p time.
  const Demand& demand_at(TimeNs time) const {
    return demands_.at(static_cast<std::size_t>(time / kCycleTime) - 1);
  }
  const std::vector<Demand>& demands() const { return demands_; }

 private:
  std::function<Demand()> cycle_;
  std::vector<Demand> demands_;
  TimeNs now_{};
};

}  // namespace cia402
