#include "motor/identification/standstill/rotor_test.hpp"

#include <algorithm>
#include <numbers>

#include "motor/control/field/induction_circuit.hpp"
#include "motor/plant/machine/temperature.hpp"

namespace motor {
namespace {

constexpr double kLower = 0.2;     // of the magnetising current
constexpr double kUpper = 0.5;     // of it, well below saturation
constexpr double kWindow = 4.0;    // rotor time constants
constexpr double kShortest = 0.2;  // s
constexpr double kLongest = 2.0;   // s

}  // namespace

SpaceVector RotorTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  if (window_ > 0) {
    take(measured, bench);
    if (++taken_ == 2 * window_) conclude(bench);
  } else {
    start_.step(measured, bench.axis);
    if (start_.steady()) begin(bench);
    if (start_.overdue()) bench.fault = StandstillFault::RotorTimeConstant;
  }
  before_ = dot(measured.current, bench.axis);
  const double magnetising = std::numbers::sqrt2 * bench.task.machine.induction.magnetising_current;
  return bench.currents.step(share() * std::min(magnetising, bench.test_current) * bench.axis, measured);
}

double RotorTest::share() const noexcept {
  return taken_ < window_ ? kUpper : kLower;
}

void RotorTest::begin(const StandstillBench& bench) noexcept {
  const InductionCircuit circuit = induction_circuit(bench.task.machine);
  const double time = kWindow * circuit.magnetising_inductance / circuit.rotor_resistance;
  window_ = steps_in(std::clamp(time, kShortest, kLongest));
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
  const double time = kControlPeriod * (taken_ + 1);
  flux_by_.add({charge_, area_, time, time * time}, flux_);
}

void RotorTest::conclude(StandstillBench& bench) noexcept {
  done_ = true;
  const auto found = flux_by_.solve();
  const double resistance = found ? (*found)[0] : 0.0;
  const double rate = found ? -(*found)[1] : 0.0;  // reciprocal of the time constant (1/s)
  if (!(resistance > 0.0 && rate > 0.0)) {
    bench.fault = resistance > 0.0 ? StandstillFault::RotorTimeConstant : StandstillFault::RotorResistance;
    return;
  }
  bench.result.rotor_resistance = resistance / resistance_factor(bench.task.winding_temperature);
  bench.result.magnetising_inductance = resistance / rate;
}

}  // namespace motor
