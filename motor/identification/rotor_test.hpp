#pragma once

#include <array>

#include "motor/identification/standstill_bench.hpp"
#include "motor/identification/steady_mean.hpp"

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
  static constexpr std::size_t kUnknowns = 4;
  using Row = std::array<double, kUnknowns>;

  double share() const noexcept;
  void begin(const StandstillBench& bench) noexcept;
  void take(const Measurement& measured, const StandstillBench& bench) noexcept;
  void conclude(StandstillBench& bench) noexcept;
  Row solution() const noexcept;

  SteadyMean start_{};
  std::array<Row, kUnknowns> products_{};  // sums of the products of charge, area, time and its square
  Row with_flux_{};                        // of the same with the flux
  double flux_ = 0.0;                      // of the rotor, since the rise of the current (V·s)
  double charge_ = 0.0;                    // integral of the current above that before (A·s)
  double area_ = 0.0;                      // integral of the flux (V·s²)
  double before_ = 0.0;                    // current (A)
  int window_ = 0;                         // steps, of the rise and of the fall
  int taken_ = 0;                          // steps
  bool done_ = false;
};

}  // namespace motor
