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
  if (steps_ == 0) start_angle_ = bench.shaft.angle();
  const double current = this->current(bench);
  const SpaceVector direction = measured.rotor * kDirections[static_cast<std::size_t>(pattern_ % kSides)];
  if (steps_ == 2 * pulse_) look(bench);
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

void PoleTest::look(const StandstillBench& bench) noexcept {
  const double sign = pattern_ < kSides ? 1.0 : -1.0;
  way_[static_cast<std::size_t>(pattern_ % kSides)] += 0.5 * sign * (bench.shaft.angle() - start_angle_);
}

void PoleTest::next_pattern(StandstillBench& bench) noexcept {
  steps_ = 0;
  if (++pattern_ < kPatterns) return;
  if (std::max(std::abs(way_[0]), std::abs(way_[1])) >= kEnough) return conclude(bench);
  grow(bench);
}

void PoleTest::grow(StandstillBench& bench) noexcept {
  pattern_ = 0;
  way_ = {};
  if (share_ < 1.0) {
    share_ = std::min(1.0, 2.0 * share_);
    return;
  }
  if (pulse_ >= kLongest) bench.fault = StandstillFault::PolePosition;
  pulse_ = std::min(kLongest, pulse_ + (pulse_ + 1) / 2);
}

/// A current at the angle a past the true axis turns the shaft with sin(a).
void PoleTest::conclude(StandstillBench& bench) noexcept {
  bench.result.pole_position = std::atan2(-(way_[0] + way_[1]), way_[0] - way_[1]);
  if (std::abs(bench.result.pole_position) > kLargest) bench.fault = StandstillFault::PolePosition;
  done_ = true;
}

}  // namespace motor
