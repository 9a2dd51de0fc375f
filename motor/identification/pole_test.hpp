#pragma once

#include <array>

#include "motor/identification/standstill_bench.hpp"

namespace motor {

/// Finds the axis of the magnets by what short currents do to the shaft. They flow 45° before and behind the axis
/// that the encoder shows, where both give torque and friction takes as much from either: forth, back, back and
/// forth, so that the shaft ends where it began. They grow until the shaft follows enough to be seen.
class PoleTest {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return done_; }

 private:
  static constexpr int kSides = 2;        // before and behind the axis
  static constexpr int kPatterns = 4;     // both sides, each with both signs
  static constexpr double kFirst = 0.25;  // of the test current, and doubled
  static constexpr int kShortest = steps_in(2e-3);
  static constexpr int kLongest = steps_in(50e-3);
  static constexpr int kRest = steps_in(20e-3);

  double current(const StandstillBench& bench) const noexcept;
  void look(const StandstillBench& bench) noexcept;
  void next_pattern(StandstillBench& bench) noexcept;
  void grow(StandstillBench& bench) noexcept;
  void conclude(StandstillBench& bench) noexcept;

  std::array<double, kSides> way_{};  // of the shaft with the current (rad)
  double start_angle_ = 0.0;          // of the shaft (rad)
  double share_ = kFirst;             // of the test current
  int pulse_ = kShortest;             // steps
  int pattern_ = 0;
  int steps_ = 0;  // in the pattern
  bool done_ = false;
};

}  // namespace motor
