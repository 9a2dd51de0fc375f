#include "motor/identification/standstill/pole_test.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace motor {
namespace {

constexpr double kEnough = 0.015;                             // rad, that the shaft turns in one current
constexpr double kEnoughCounts = 16.0;                        // of the encoder, if that is more
constexpr double kSeen = 0.002;                               // rad, that is surely motion
constexpr double kFarthest = 0.45;                            // rad, expected of the shaft without its load
constexpr double kFarthestUnseen = 0.15;                      // rad, where nothing was seen
constexpr double kLargest = 15.0 * std::numbers::pi / 180.0;  // electrical rad, that a sound encoder is wrong
/// How long a current is (steps).
constexpr std::array kPulses{steps_in(2e-3),  steps_in(3e-3),  steps_in(4.5e-3), steps_in(7e-3), steps_in(10e-3),
                             steps_in(15e-3), steps_in(22e-3), steps_in(33e-3),  steps_in(50e-3)};
constexpr std::array kForthAndBack{1.0, -1.0, -1.0, 1.0, 0.0};
constexpr double kDiagonal = 0.5 * std::numbers::sqrt2;
/// Before and behind the axis, each with both signs. What a salient rotor adds to the torque has one sign on one
/// side and the other on the other: in this order the shaft drifts forth and back.
struct Pattern {
  SpaceVector direction;
  double sign;
};
constexpr Pattern kBefore{{kDiagonal, kDiagonal}, 1.0};
constexpr Pattern kBehind{{kDiagonal, -kDiagonal}, 1.0};
constexpr std::array kPatterns{kBefore, kBehind, Pattern{kBehind.direction, -1.0},
                               Pattern{kBefore.direction, -1.0}};
constexpr int kCoast = steps_in(7.5e-3);  // a part of a rest, to see how fast the shaft still is
constexpr int kLongestRest = steps_in(0.3);
constexpr double kStopped = 1e-4;   // rad in such a part
constexpr double kEvenness = 0.15;  // change of the way from part to part

/// How far a shaft without friction would turn in one current of @p pulse steps, as it is believed to be (rad).
double expected_way(const StandstillBench& bench, int pulse) noexcept {
  const MachineData& machine = bench.task.machine;
  const double torque =
      1.5 * machine.pole_pairs * machine.synchronous.magnet_flux * kDiagonal * bench.test_current;
  const double time = pulse * kControlPeriod;
  return 0.5 * torque / bench.believed_inertia() * time * time;
}

}  // namespace

SpaceVector PoleTest::step(const Measurement& measured, StandstillBench& bench) noexcept {
  const double angle = bench.shaft.angle();
  if (steps_ == 0) begin_pattern(angle);
  follow(measured, angle);
  const SpaceVector wanted = current(bench) * (measured.rotor * kPatterns[pattern_].direction);
  if (++steps_ >= 4 * kPulses[length_]) rest(bench, angle);
  bench.follow_pole(measured);
  return bench.currents.step(wanted, measured);
}

double PoleTest::current(const StandstillBench& bench) const noexcept {
  const auto part = static_cast<std::size_t>(steps_ / kPulses[length_]);
  return kPatterns[pattern_].sign * bench.test_current * kForthAndBack[std::min(part, kForthAndBack.size() - 1)];
}

void PoleTest::begin_pattern(double angle) noexcept {
  start_angle_ = angle;
  charge_ = {};
  pull_ = {};
}

/// Waits until the shaft has stopped, or goes on evenly: without friction, which is not due to the next current.
/// One that swings with an elastic load gets more time.
void PoleTest::rest(StandstillBench& bench, double angle) noexcept {
  const int rested = steps_ - 4 * kPulses[length_];
  lowest_ = std::min(lowest_, angle);
  highest_ = std::max(highest_, angle);
  if (rested % kCoast != 0) return;
  const double moved = angle - coast_angle_;
  const double change = std::abs(moved - drift_ * kCoast);
  const double swing = highest_ - lowest_ - std::abs(moved);
  coast_angle_ = lowest_ = highest_ = angle;
  drift_ = moved / kCoast;
  const bool even = rested > kCoast && std::max(change, swing) < kStopped + kEvenness * std::abs(moved);
  if (even || rested >= kLongestRest) next_pattern(bench);
}

/// Until friction may have turned it back.
void PoleTest::follow(const Measurement& measured, double angle) noexcept {
  const int pulse = kPulses[length_];
  if (steps_ > pulse + pulse / 2) return;
  charge_ = charge_ + kControlPeriod * (measured.current * conjugate(measured.rotor));
  pull_ = pull_ + kControlPeriod * charge_;
  look(angle - start_angle_ - drift_ * steps_);
}

void PoleTest::look(double way) noexcept {
  way_by_.add({pull_.re, pull_.im}, way);
  furthest_ = std::max(furthest_, std::abs(way));
}

void PoleTest::next_pattern(StandstillBench& bench) noexcept {
  steps_ = 0;
  if (++pattern_ < kPatterns.size()) return;
  const double increment = 2.0 * std::numbers::pi / increments_per_revolution(bench.task.machine);
  if (furthest_ >= std::max(kEnough, kEnoughCounts * increment)) return conclude(bench);
  grow(bench);
}

void PoleTest::grow(StandstillBench& bench) noexcept {
  const double farthest = furthest_ >= kSeen ? kFarthest : kFarthestUnseen;
  pattern_ = 0;
  way_by_ = {};
  furthest_ = 0.0;
  if (++length_ < kPulses.size() && expected_way(bench, kPulses[length_]) < farthest) return;
  length_ = 0;
  bench.fault = StandstillFault::PolePosition;
}

/// A current at the angle a past the true axis turns the shaft with sin(a): its way is a sum of what the currents
/// across and along the axis of the encoder do, with the cosine and the negative sine of the deviation.
void PoleTest::conclude(StandstillBench& bench) noexcept {
  done_ = true;
  const auto found = way_by_.solve();
  if (found) bench.result.pole_position = std::atan2(-(*found)[0], (*found)[1]);
  if (!found || std::abs(bench.result.pole_position) > kLargest) bench.fault = StandstillFault::PolePosition;
}

}  // namespace motor
