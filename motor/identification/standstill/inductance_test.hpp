#pragma once

#include <cstdint>

#include "motor/identification/standstill/bench/standstill_bench.hpp"

namespace motor {

/// An inductance by voltage pulses around a direct current along the axis of the bench. Their sign changes in
/// every period, so that the current swings evenly: resistance and induced voltages take as much from one sign as
/// from the other, and the shaft gets no mean torque. What the valves lose is subtracted by the signs of the phase
/// currents.
class InductanceTest {
 public:
  enum class Direction : std::uint8_t { Along, Across };

  /// @p expected is what the inductance is believed to be (H).
  InductanceTest(Direction direction, double expected) noexcept : direction_{direction}, inductance_{expected} {}

  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return pass_ >= kPasses; }
  /// What was found (H).
  double inductance() const noexcept { return inductance_; }

 private:
  static constexpr int kPasses = 2;  // a small and a large amplitude
  static constexpr int kSettling = steps_in(40e-3);
  static constexpr int kSwinging = steps_in(4e-3);
  static constexpr int kPulses = 400;  // an even number

  SpaceVector pulse_direction(const StandstillBench& bench) const noexcept;
  double amplitude(const StandstillBench& bench) const noexcept;
  void begin_pass(const Measurement& measured, StandstillBench& bench) noexcept;
  void take(const Measurement& measured, const StandstillBench& bench, double sign) noexcept;
  void end_pass(StandstillBench& bench) noexcept;

  Direction direction_;
  double inductance_;
  double pulse_ = 0.0;    // V
  double flux_ = 0.0;     // sum of all changes, each with its sign (V·s)
  double current_ = 0.0;  // the same (A)
  SpaceVector before_{};  // current (A)
  int pass_ = 0;
  int steps_ = 0;  // of the pass
};

}  // namespace motor
