#include "motor/identification/standstill/resistance_test.hpp"

#include <algorithm>
#include <array>

#include "motor/plant/machine/temperature.hpp"

namespace motor {
namespace {

constexpr double kLowerShare = 0.5;  // of the test current

}  // namespace

SpaceVector ResistanceTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  mean_.step(measured, bench.axis);
  if (mean_.steady()) {
    done_ = true;
    conclude(bench);
  } else if (mean_.overdue()) {
    bench.fault = StandstillFault::StatorResistance;
  }
  const double share = level_ == Level::Lower ? kLowerShare : 1.0;
  return bench.currents.step(share * bench.test_current * bench.axis, measured);
}

DirectCurrent ResistanceTest::found(const StandstillBench& bench) const noexcept {
  const std::array<double, 3> direction = phase_values(bench.axis);
  const auto to = std::ranges::max_element(direction) - direction.begin();
  const auto from = std::ranges::min_element(direction) - direction.begin();
  const auto between = [to, from](SpaceVector a) {
    const std::array<double, 3> phases = phase_values(a);
    return phases[static_cast<std::size_t>(to)] - phases[static_cast<std::size_t>(from)];
  };
  return {between(mean_.voltage()), between(mean_.current())};
}

void ResistanceTest::conclude(StandstillBench& bench) const noexcept {
  const DirectCurrent level = found(bench);
  if (level_ == Level::Lower) {
    bench.lower_level = level;
    return;
  }
  const double resistance =
      (level.voltage - bench.lower_level.voltage) / (level.current - bench.lower_level.current);
  bench.warm_resistance = resistance;
  bench.result.stator_resistance = resistance / resistance_factor(bench.task.winding_temperature);
  bench.result.threshold_voltage = 0.5 * (level.voltage - resistance * level.current);
}

}  // namespace motor
