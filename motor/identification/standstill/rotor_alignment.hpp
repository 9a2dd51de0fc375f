#pragma once

#include "motor/identification/standstill/bench/standstill_bench.hpp"

namespace motor {

/// Turns a rotor that no encoder sees to phase U: a constant current that leads it there from a quarter of a turn
/// away, so that it is not left where it would not fall either way.
class RotorAlignment {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return steps_ >= kDuration; }

 private:
  static constexpr int kRise = steps_in(0.3);
  static constexpr int kHold = steps_in(0.2);
  static constexpr int kTurn = steps_in(0.5);
  static constexpr int kDuration = kRise + kHold + kTurn + kHold;

  int steps_ = 0;
};

}  // namespace motor
