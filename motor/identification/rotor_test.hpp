#pragma once

#include <cstdint>

#include "motor/identification/standstill_bench.hpp"
#include "motor/identification/steady_mean.hpp"

namespace motor {

/// Rotor resistance and magnetising inductance of an induction machine: a direct current rises from one small
/// value to another, and the voltage that it takes falls with the time constant of the rotor. The flux psi of the
/// rotor follows from what was given, and dpsi/dt = R_R i - R_R/L_M psi; the integral of that is fitted by least
/// squares. All counts from the state before the step, so what the valves lose cancels.
class RotorTest {
 public:
  SpaceVector step(const Measurement& measured, StandstillBench& bench) noexcept;
  bool done() const noexcept { return done_; }

 private:
  /// Sums of products of flux, charge and the integral of the flux.
  struct Sums {
    double flux_charge = 0.0;
    double flux_area = 0.0;
    double charge_charge = 0.0;
    double charge_area = 0.0;
    double area_area = 0.0;
  };

  void begin(const StandstillBench& bench) noexcept;
  void take(const Measurement& measured, const StandstillBench& bench) noexcept;
  void conclude(StandstillBench& bench) noexcept;

  SteadyMean start_{};
  Sums sums_{};
  double flux_ = 0.0;    // of the rotor, since the step of the current (V·s)
  double charge_ = 0.0;  // integral of the current above that before (A·s)
  double area_ = 0.0;    // integral of the flux (V·s²)
  double before_ = 0.0;  // current (A)
  int left_ = 0;         // steps to take
  bool rising_ = false;
  bool done_ = false;
};

}  // namespace motor
