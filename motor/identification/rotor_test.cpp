#include "motor/identification/rotor_test.hpp"

#include <algorithm>
#include <numbers>

#include "motor/induction_circuit.hpp"
#include "motor/temperature.hpp"

namespace motor {
namespace {

constexpr double kLower = 0.1;     // of the magnetising current
constexpr double kUpper = 0.4;     // of it, far below saturation
constexpr double kWindow = 4.0;    // rotor time constants
constexpr double kShortest = 0.2;  // s
constexpr double kLongest = 2.0;   // s

}  // namespace

SpaceVector RotorTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  const double magnetising = std::numbers::sqrt2 * bench.task.machine.induction.magnetising_current;
  const double current = std::min(magnetising, bench.test_current);
  if (rising_) {
    take(measured, bench);
    if (--left_ == 0) conclude(bench);
  } else {
    start_.step(measured, bench.axis);
    if (start_.steady()) begin(bench);
    if (start_.overdue()) bench.fault = StandstillFault::RotorTimeConstant;
  }
  before_ = dot(measured.current, bench.axis);
  return bench.currents.step((rising_ ? kUpper : kLower) * current * bench.axis, measured);
}

void RotorTest::begin(const StandstillBench& bench) noexcept {
  const InductionCircuit circuit = induction_circuit(bench.task.machine);
  const double time = kWindow * circuit.magnetising_inductance / circuit.rotor_resistance;
  left_ = steps_in(std::clamp(time, kShortest, kLongest));
  rising_ = true;
}

void RotorTest::take(const Measurement& measured, const StandstillBench& bench) noexcept {
  const double now = dot(measured.current, bench.axis);
  const double current = 0.5 * (now + before_) - dot(start_.current(), bench.axis);
  const double voltage = dot(measured.voltage - start_.voltage(), bench.axis);
  const double change =
      kControlPeriod * (voltage - bench.warm_resistance * current) - bench.result.leakage * (now - before_);
  area_ += kControlPeriod * (flux_ + 0.5 * change);
  flux_ += change;
  charge_ += kControlPeriod * current;
  sums_.flux_charge += flux_ * charge_;
  sums_.flux_area += flux_ * area_;
  sums_.charge_charge += charge_ * charge_;
  sums_.charge_area += charge_ * area_;
  sums_.area_area += area_ * area_;
}

void RotorTest::conclude(StandstillBench& bench) noexcept {
  done_ = true;
  const double determinant = sums_.charge_charge * sums_.area_area - sums_.charge_area * sums_.charge_area;
  const double resistance =
      (sums_.flux_charge * sums_.area_area - sums_.flux_area * sums_.charge_area) / determinant;
  const double rate =
      (sums_.flux_charge * sums_.charge_area - sums_.flux_area * sums_.charge_charge) / determinant;
  if (!(resistance > 0.0 && rate > 0.0)) {
    bench.fault = resistance > 0.0 ? StandstillFault::RotorTimeConstant : StandstillFault::RotorResistance;
    return;
  }
  bench.result.rotor_resistance = resistance / resistance_factor(bench.task.winding_temperature);
  bench.result.magnetising_inductance = resistance / rate;
}

}  // namespace motor
