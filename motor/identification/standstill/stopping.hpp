#pragma once

#include "motor/identification/standstill/bench/standstill_bench.hpp"

namespace motor {

/// Brings the shaft of a synchronous machine to rest that nothing else brakes: a current along the axis that was
/// found holds it like a spring, and one across it takes the speed away.
class Stopping {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return steps_ >= kLongest || quiet_; }

 private:
  static constexpr int kPart = steps_in(20e-3);  // over which the shaft must not move
  static constexpr int kLongest = 30 * kPart;

  void look(double angle) noexcept;

  SpaceVector axis_{};       // of the holding current
  double last_angle_ = 0.0;  // of the shaft, a step before (rad)
  double part_angle_ = 0.0;  // at the start of the part (rad)
  double speed_ = 0.0;       // smoothed (rad/s)
  int steps_ = 0;
  bool quiet_ = false;
};

}  // namespace motor
