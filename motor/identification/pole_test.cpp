#include "motor/identification/pole_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kEnough = 0.015;                             // rad, that the shaft turns in one current
constexpr double kEnoughCounts = 16.0;                        // of the encoder, if that is more
constexpr double kFarthest = 0.3;                             // rad, expected where nothing is seen
constexpr double kLargest = 15.0 * std::numbers::pi / 180.0;  // electrical rad, that a sound encoder is wrong
constexpr int kRest = steps_in(20e-3);
/// How high and how long a current is.
struct Attempt {
  double share;  // of the test current
  int pulse;     // steps
};
constexpr std::array kAttempts{
    Attempt{0.5, steps_in(2e-3)},  Attempt{0.5, steps_in(3e-3)},  Attempt{0.5, steps_in(4.5e-3)},
    Attempt{0.5, steps_in(7e-3)},  Attempt{0.5, steps_in(10e-3)}, Attempt{1.0, steps_in(7e-3)},
    Attempt{1.0, steps_in(10e-3)}, Attempt{1.0, steps_in(15e-3)}, Attempt{1.0, steps_in(22e-3)},
    Attempt{1.0, steps_in(33e-3)}, Attempt{1.0, steps_in(50e-3)}};
constexpr std::array kForthAndBack{1.0, -1.0, -1.0, 1.0, 0.0};
/// Directions against the axis: 45° before and behind.
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;
constexpr std::array kDirections{SpaceVector{kDiagonal, kDiagonal}, SpaceVector{kDiagonal, -kDiagonal}};

/// How far a shaft without friction would turn in one current of @p attempt, as it is believed to be (rad).
double expected_way(const StandstillBench& bench, const Attempt& attempt) noexcept {
  const MachineData& machine = bench.task.machine;
  const double torque =
      1.5 * machine.pole_pairs * machine.synchronous.magnet_flux * kDiagonal * attempt.share * bench.test_current;
  const double time = attempt.pulse * kControlPeriod;
  return 0.5 * torque / std::max(machine.inertia, bench.task.settings.inertia) * time * time;
}

}  // namespace

SpaceVector PoleTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  follow(measured, bench);
  const double current = this->current(bench);
  const SpaceVector direction = measured.rotor * kDirections[static_cast<std::size_t>(pattern_ % kSides)];
  const int pulse = kAttempts[attempt_].pulse;
  if (++steps_ >= 4 * pulse + std::max(kRest, pulse)) next_pattern(bench);
  bench.axis =
      measured.rotor * SpaceVector{std::cos(bench.result.pole_position), std::sin(bench.result.pole_position)};
  return bench.currents.step(current * direction, measured);
}

double PoleTest::current(const StandstillBench& bench) const noexcept {
  const auto part = static_cast<std::size_t>(steps_ / kAttempts[attempt_].pulse);
  const double sign = pattern_ < kSides ? 1.0 : -1.0;
  return sign * kAttempts[attempt_].share * bench.test_current *
         kForthAndBack[std::min(part, kForthAndBack.size() - 1)];
}

void PoleTest::follow(const Measurement& measured, const StandstillBench& bench) noexcept {
  if (steps_ == 0) {
    start_angle_ = bench.shaft.angle();
    charge_ = {};
    pull_ = {};
  }
  const int pulse = kAttempts[attempt_].pulse;
  if (steps_ > pulse + pulse / 2) return;
  charge_ = charge_ + kControlPeriod * (measured.current * conjugate(measured.rotor));
  pull_ = pull_ + kControlPeriod * charge_;
  look(bench.shaft.angle() - start_angle_);
}

void PoleTest::look(double way) noexcept {
  sums_.along_along += pull_.re * pull_.re;
  sums_.along_across += pull_.re * pull_.im;
  sums_.across_across += pull_.im * pull_.im;
  sums_.along_way += pull_.re * way;
  sums_.across_way += pull_.im * way;
  furthest_ = std::max(furthest_, std::abs(way));
}

void PoleTest::next_pattern(StandstillBench& bench) noexcept {
  steps_ = 0;
  if (++pattern_ < kPatterns) return;
  const double increment = 2.0 * std::numbers::pi / increments_per_revolution(bench.task.machine);
  if (furthest_ >= std::max(kEnough, kEnoughCounts * increment)) return conclude(bench);
  grow(bench);
}

void PoleTest::grow(StandstillBench& bench) noexcept {
  pattern_ = 0;
  sums_ = {};
  furthest_ = 0.0;
  if (++attempt_ < kAttempts.size() && expected_way(bench, kAttempts[attempt_]) < kFarthest) return;
  attempt_ = 0;
  bench.fault = StandstillFault::PolePosition;
}

/// A current at the angle a past the true axis turns the shaft with sin(a): its way is a sum of what the currents
/// across and along the axis of the encoder do, with the cosine and the negative sine of the deviation.
void PoleTest::conclude(StandstillBench& bench) noexcept {
  const double cosine = sums_.across_way * sums_.along_along - sums_.along_way * sums_.along_across;
  const double sine = sums_.across_way * sums_.along_across - sums_.along_way * sums_.across_across;
  bench.result.pole_position = std::atan2(sine, cosine);
  if (std::abs(bench.result.pole_position) > kLargest) bench.fault = StandstillFault::PolePosition;
  done_ = true;
}

}  // namespace motor
