#pragma once

#include "motor/identification/standstill_bench.hpp"

namespace motor {

/// Whether the shaft stays where it is while no current flows.
class RestTest {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept {
    ++steps_;
    if (bench.shaft.travel() > kTolerance) bench.fault = StandstillFault::ShaftTurns;
    return bench.currents.step({}, measured);
  }
  bool done() const noexcept { return steps_ >= kDuration; }

 private:
  static constexpr int kDuration = steps_in(0.1);
  static constexpr double kTolerance = 0.02;  // rad

  int steps_ = 0;
};

}  // namespace motor
