#pragma once

#include <array>
#include <cstddef>

#include "motor/identification/model/saturation_curve.hpp"
#include "motor/identification/standstill/bench/standstill_bench.hpp"
#include "motor/identification/standstill/bench/steady_mean.hpp"

namespace motor {

/// Saturation characteristic of an induction machine at standstill: a direct current rises in steps, and what its
/// voltage has beyond the resistance is the change of the rotor's flux until that stands. All counts from a small
/// current, at which the flux goes by the inductance that was found without saturation.
class CurveTest {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return level_ == kLevels; }

 private:
  static constexpr std::size_t kLevels = 4;

  void begin(const StandstillBench& bench) noexcept;
  void take(const Measurement& measured, StandstillBench& bench) noexcept;
  void end_level(StandstillBench& bench) noexcept;
  void conclude(StandstillBench& bench) const noexcept;

  SteadyMean start_{};
  std::array<FluxPoint, kLevels> points_{};
  std::size_t level_ = 0;
  int window_ = 0;           // steps at a level; 0 = before the first
  int tail_ = 0;             // its last steps, in which the flux stands
  int taken_ = 0;            // steps
  double start_flux_ = 0.0;  // at the small current (V·s)
  double flux_ = 0.0;        // of the rotor, since then (V·s)
  double before_ = 0.0;      // current (A)
  double rate_ = 0.0;        // sum over the tail: what is no change of flux (V)
  double current_ = 0.0;     // sum over the tail (A)
};

}  // namespace motor
