#pragma once

#include "motor/identification/standstill/bench/standstill_bench.hpp"

namespace motor {

/// Whether the shaft stays where it is while no current flows.
class RestTest {
 public:
  RestTest() noexcept = default;
  /// For @p duration (s).
  explicit RestTest(double duration) noexcept : left_{steps_in(duration)} {}

  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept {
    --left_;
    if (bench.shaft.travel() > kTolerance) bench.fault = StandstillFault::ShaftTurns;
    return bench.currents.step({}, measured);
  }
  bool done() const noexcept { return left_ <= 0; }

 private:
  static constexpr double kTolerance = 0.02;  // rad

  int left_ = 0;
};

}  // namespace motor
