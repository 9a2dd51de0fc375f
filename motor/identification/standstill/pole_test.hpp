#pragma once

#include <cstddef>

#include "motor/identification/model/least_squares.hpp"
#include "motor/identification/standstill/bench/standstill_bench.hpp"

namespace motor {

/// Finds the axis of the magnets by what short currents do to the shaft. They flow 45° before and behind the axis
/// that the encoder shows, where both give torque and friction takes as much from either: forth, back, back and
/// forth, so that the shaft ends where it began. They become longer until the shaft follows enough to be seen; its
/// way is held against the currents that have really flown.
class PoleTest {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return done_; }

 private:
  double current(const StandstillBench& bench) const noexcept;
  void begin_pattern(double angle) noexcept;
  void follow(const Measurement& measured, double angle) noexcept;
  void look(double way) noexcept;
  void rest(StandstillBench& bench, double angle) noexcept;
  void next_pattern(StandstillBench& bench) noexcept;
  void grow(StandstillBench& bench) noexcept;
  void conclude(StandstillBench& bench) noexcept;

  LeastSquares<2> way_by_{};  // what the currents along and across the axis would have made of the shaft
  SpaceVector charge_{};      // integral of the current in the encoder's frame (A·s)
  SpaceVector pull_{};        // integral of that (A·s²)
  double furthest_ = 0.0;     // way (rad)
  double start_angle_ = 0.0;  // of the shaft (rad)
  std::size_t length_ = 0;    // of the currents, in their table
  double coast_angle_ = 0.0;  // of the shaft some time before, while it rests (rad)
  double lowest_ = 0.0;       // since then (rad)
  double highest_ = 0.0;      // since then (rad)
  double drift_ = 0.0;        // of the shaft from that pattern (rad a step)
  std::size_t pattern_ = 0;
  int steps_ = 0;  // in the pattern
  bool done_ = false;
};

}  // namespace motor
