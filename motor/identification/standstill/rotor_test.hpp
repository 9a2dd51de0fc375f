#pragma once

#include "motor/identification/model/least_squares.hpp"
#include "motor/identification/standstill/bench/standstill_bench.hpp"
#include "motor/identification/standstill/bench/steady_mean.hpp"

namespace motor {

/// Rotor resistance and magnetising inductance of an induction machine: a direct current rises from one small
/// value to another and falls back, and the voltage that it takes follows with the time constant of the rotor. The
/// flux psi of the rotor comes from what was given, and dpsi/dt = R_R i - R_R/L_M psi; the integral of that is
/// fitted by least squares, together with a drift. All counts from the state before, so what the valves lose
/// cancels.
class RotorTest {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return done_; }

 private:
  double share() const noexcept;
  void begin(const StandstillBench& bench) noexcept;
  void take(const Measurement& measured, const StandstillBench& bench) noexcept;
  void conclude(StandstillBench& bench) noexcept;

  SteadyMean start_{};
  LeastSquares<4> flux_by_{};  // charge, area, time and its square
  double flux_ = 0.0;          // of the rotor, since the rise of the current (V·s)
  double charge_ = 0.0;        // integral of the current above that before (A·s)
  double area_ = 0.0;          // integral of the flux (V·s²)
  double before_ = 0.0;        // current (A)
  int window_ = 0;             // steps, of the rise and of the fall
  int taken_ = 0;              // steps
  bool done_ = false;
};

}  // namespace motor
