#include "motor/identification/pole_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kEnough = 0.02;                              // rad, what a coarse encoder sees well
constexpr double kLargest = 15.0 * std::numbers::pi / 180.0;  // electrical rad, that a sound encoder is wrong
constexpr std::array kForthAndBack{1.0, -1.0, -1.0, 1.0, 0.0};
/// Directions against the axis: 45° before and behind.
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;
constexpr std::array kDirections{SpaceVector{kDiagonal, kDiagonal}, SpaceVector{kDiagonal, -kDiagonal}};

}  // namespace

SpaceVector PoleTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  follow(measured, bench);
  const double current = this->current(bench);
  const SpaceVector direction = measured.rotor * kDirections[static_cast<std::size_t>(pattern_ % kSides)];
  if (++steps_ >= 4 * pulse_ + std::max(kRest, pulse_)) next_pattern(bench);
  bench.axis =
      measured.rotor * SpaceVector{std::cos(bench.result.pole_position), std::sin(bench.result.pole_position)};
  return bench.currents.step(current * direction, measured);
}

double PoleTest::current(const StandstillBench& bench) const noexcept {
  const auto part = static_cast<std::size_t>(steps_ / pulse_);
  const double sign = pattern_ < kSides ? 1.0 : -1.0;
  return sign * share_ * bench.test_current * kForthAndBack[std::min(part, kForthAndBack.size() - 1)];
}

void PoleTest::follow(const Measurement& measured, const StandstillBench& bench) noexcept {
  if (steps_ == 0) {
    start_angle_ = bench.shaft.angle();
    charge_ = {};
    pull_ = {};
  }
  if (steps_ > 2 * pulse_) return;
  charge_ = charge_ + kControlPeriod * (measured.current * conjugate(measured.rotor));
  pull_ = pull_ + kControlPeriod * charge_;
  if (steps_ == 2 * pulse_) look(bench.shaft.angle() - start_angle_);
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
  if (furthest_ >= kEnough) return conclude(bench);
  grow(bench);
}

void PoleTest::grow(StandstillBench& bench) noexcept {
  pattern_ = 0;
  sums_ = {};
  furthest_ = 0.0;
  if (share_ < 1.0) {
    share_ = std::min(1.0, 2.0 * share_);
    return;
  }
  if (pulse_ >= kLongest) bench.fault = StandstillFault::PolePosition;
  pulse_ = std::min(kLongest, pulse_ + (pulse_ + 1) / 2);
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
