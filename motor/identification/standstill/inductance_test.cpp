#include "motor/identification/standstill/inductance_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace motor {
namespace {

constexpr double kBias = 0.7;            // of the test current, that stands
constexpr double kFirstAmplitude = 0.1;  // of the test current, to learn the rough inductance by
constexpr double kAlong = 0.3;           // of the test current
constexpr double kLeast = 0.01;          // of the test current, to be seen at all
constexpr double kVoltageShare = 0.6;    // of what the DC link gives, for the pulses
/// Amplitudes across the axis, of the standing current.
constexpr std::array kAcross{0.6, 0.55, 0.5, 0.45, 0.4, 0.35, 0.3, 0.25, 0.2};

/// The smallest current of a phase when a swing of @p swing (A) along @p direction turns back.
double least_phase_current(SpaceVector standing, SpaceVector direction, double swing) noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (const double sign : {1.0, -1.0})
    for (const double phase : phase_values(standing + sign * swing * direction))
      least = std::min(least, std::abs(phase));
  return least;
}

}  // namespace

SpaceVector InductanceTest::pulse_direction(const StandstillBench& bench) const noexcept {
  return direction_ == Direction::Along ? bench.axis : bench.axis * SpaceVector{0.0, 1.0};
}

/// How far the current swings to either side (A). Across the axis phase currents change their signs; the swing
/// turns back where all of them are far from 0, since what the valves lose is certain there.
double InductanceTest::amplitude(const StandstillBench& bench) const noexcept {
  if (pass_ == 0) return kFirstAmplitude * bench.test_current;
  if (direction_ == Direction::Along) return kAlong * bench.test_current;
  const double standing = kBias * bench.test_current;
  double best = kAcross[0];
  double margin = 0.0;
  for (const double share : kAcross) {
    const double least = least_phase_current(standing * bench.axis, pulse_direction(bench), share * standing);
    if (least <= margin) continue;
    margin = least;
    best = share;
  }
  return best * standing;
}

void InductanceTest::begin_pass(const Measurement& measured, StandstillBench& bench) noexcept {
  const double most = kVoltageShare * std::numbers::inv_sqrt3 * measured.dc_voltage;
  pulse_ = std::min(most, 2.0 * inductance_ * amplitude(bench) / kControlPeriod);
  if (pulse_ * kControlPeriod < 2.0 * inductance_ * kLeast * bench.test_current)
    bench.fault = StandstillFault::VoltageLimited;
  flux_ = 0.0;
  current_ = 0.0;
}

/// The signs of what was asked for two periods ago and of what is asked for now are the same.
void InductanceTest::take(const Measurement& measured, const StandstillBench& bench, double sign) noexcept {
  const std::array<double, 3> signs = phase_signs(before_);
  const SpaceVector lost = bench.result.threshold_voltage * vector_of(signs) +
                           0.5 * bench.warm_resistance * (before_ + measured.current);
  const SpaceVector direction = pulse_direction(bench);
  flux_ += sign * kControlPeriod * dot(measured.voltage - lost, direction);
  current_ += sign * dot(measured.current - before_, direction);
}

void InductanceTest::end_pass(StandstillBench& bench) noexcept {
  steps_ = 0;
  ++pass_;
  if (current_ <= kPulses * kLeast * bench.test_current || flux_ <= 0.0) {
    bench.fault = bench.task.machine.type == MachineType::Synchronous ? StandstillFault::StatorReactance
                                                                      : StandstillFault::Leakage;
    return;
  }
  inductance_ = flux_ / current_;
}

SpaceVector InductanceTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  if (steps_ == kSettling) begin_pass(measured, bench);
  const int pulses = steps_ - kSettling;
  const double sign = pulses % 2 == 0 ? 1.0 : -1.0;
  if (pulses >= kSwinging) take(measured, bench, sign);
  before_ = measured.current;
  // The first one leads the current to one side only.
  const double share = pulses < 0 ? 0.0 : pulses == 0 ? 0.5 : 1.0;
  ++steps_;
  if (pulses + 1 == kSwinging + kPulses) end_pass(bench);
  const SpaceVector given =
      bench.currents.step(kBias * bench.test_current * bench.axis, measured, pulses < 0 ? 0.0 : pulse_);
  return given + share * sign * pulse_ * pulse_direction(bench);
}

}  // namespace motor
