#include "motor/identification/standstill/stopping.hpp"

#include <algorithm>
#include <cmath>

namespace motor {
namespace {

constexpr double kHolding = 0.5;    // of the test current
constexpr double kBraking = 0.5;    // of it, at most
constexpr double kDamping = 100.0;  // 1/s, with which the speed falls
constexpr double kSmoothing = 1.0 / 16.0;
constexpr double kStopped = 1e-4;  // rad in a part

/// Current that takes away a speed (A s/rad).
double braking_gain(const StandstillBench& bench) noexcept {
  const MachineData& machine = bench.task.machine;
  return kDamping * bench.believed_inertia() / (1.5 * machine.pole_pairs * machine.synchronous.magnet_flux);
}

}  // namespace

SpaceVector Stopping::step(const Measurement& measured, StandstillBench& bench) noexcept {
  const double angle = bench.shaft.angle();
  bench.follow_pole(measured);
  if (steps_ == 0) {
    axis_ = bench.axis;
    last_angle_ = angle;
    part_angle_ = angle;
  }
  speed_ += kSmoothing * ((angle - last_angle_) / kControlPeriod - speed_);
  last_angle_ = angle;
  if (++steps_ % kPart == 0) look(angle);
  const double most = kBraking * bench.test_current;
  const double braking = std::clamp(-braking_gain(bench) * speed_, -most, most);
  return bench.currents.step(
      kHolding * bench.test_current * axis_ + braking * (bench.axis * SpaceVector{0.0, 1.0}), measured);
}

void Stopping::look(double angle) noexcept {
  quiet_ = std::abs(angle - part_angle_) < kStopped;
  part_angle_ = angle;
}

}  // namespace motor
