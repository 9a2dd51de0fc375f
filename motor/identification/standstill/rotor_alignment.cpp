#include "motor/identification/standstill/rotor_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {

SpaceVector RotorAlignment::step(const Measurement& measured, StandstillBench& bench) noexcept {
  const double risen = std::min(1.0, static_cast<double>(steps_) / kRise);
  const double turned = std::clamp(static_cast<double>(steps_ - kRise - kHold) / kTurn, 0.0, 1.0);
  const double angle = 0.5 * std::numbers::pi * (1.0 - turned);
  ++steps_;
  bench.axis = {1.0, 0.0};
  return bench.currents.step(bench.test_current * risen * SpaceVector{std::cos(angle), std::sin(angle)}, measured);
}

}  // namespace motor
