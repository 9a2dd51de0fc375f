#include "drive/setpoint_channel/ramp_function_generator.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/motor/reference/reference_file.hpp"

namespace drive {
namespace {

constexpr double kStep = 125e-6;

/// Steps until the output is at @p target; returns how many.
int steps_to(RampFunctionGenerator& ramp, double target, const RampSlopes& slopes) {
  int steps = 0;
  while (ramp.output() != target && steps < 1'000'000) {
    ramp.step(kStep, target, slopes);
    ++steps;
  }
  return steps;
}

TEST(RampFunctionGenerator, ReachesTheMaximumSpeedAfterTheRampTimeWithinOneStep) {
  RampFunctionGenerator ramp;

  EXPECT_NEAR(steps_to(ramp, 750.0, {ramp_slope(750.0, 10.0), 1.0}), 80000, 1);
}

TEST(RampFunctionGenerator, TakesTheShareOfTheRampTimeThatTheSpeedHasInTheMaximumSpeed) {
  RampFunctionGenerator ramp;
  ramp.start(-300.0);

  EXPECT_NEAR(steps_to(ramp, 0.0, {1.0, ramp_slope(750.0, 10.0)}), 32000, 1);
}

TEST(RampFunctionGenerator, PassesZeroOnAReversalDownWithOneSlopeAndUpWithTheOther) {
  RampFunctionGenerator ramp;
  ramp.start(100.0);

  // 0.1 s down and 0.5 s up; the step that passes zero loses nothing.
  EXPECT_NEAR(steps_to(ramp, -100.0, {200.0, 1000.0}), 4800, 1);
}

TEST(RampFunctionGenerator, UsesTheRampDownTimeBetweenTwoSpeedsOfTheSameSign) {
  RampFunctionGenerator ramp;
  ramp.start(-100.0);

  ramp.step(0.01, -50.0, {1.0, 1000.0});

  EXPECT_DOUBLE_EQ(ramp.output(), -90.0);
}

TEST(RampFunctionGenerator, IsAStepForARampTimeOfZero) {
  RampFunctionGenerator ramp;
  const RampSlopes steps{ramp_slope(750.0, 0.0), ramp_slope(750.0, 0.0)};

  EXPECT_EQ(ramp.step(kStep, 750.0, steps), 750.0);
  EXPECT_EQ(ramp.step(kStep, -750.0, steps), -750.0);
  EXPECT_EQ(ramp.step(kStep, 0.0, steps), 0.0);
}

TEST(RampFunctionGenerator, StopsAtOnceWhereAMaximumSpeedOfZeroGivesNoRamp) {
  RampFunctionGenerator ramp;
  ramp.start(10.0);

  EXPECT_EQ(ramp.step(kStep, 0.0, {ramp_slope(0.0, 10.0), ramp_slope(0.0, 10.0)}), 0.0);
}

constexpr double kRpm = 0.10471975511965977;  // rad/s
constexpr double kRampTime = 10.0;            // s
/// 300 rad/s² both ways, built up in 1 s and gone in 2 s.
constexpr RampSlopes kRounded{300.0, 300.0, 1.0, 2.0};

TEST(RampFunctionGenerator, FollowsTheRoundedRampOfTheReference) {
  const reference::File file{"f2_rfg"};
  const double maximum = file.number("/parameters/p1082") * kRpm;
  const auto slope = [&](const char* time) { return ramp_slope(maximum, file.number(time)); };
  const RampSlopes setpoint{slope("/parameters/p1120"), slope("/parameters/p1121"),
                            file.number("/parameters/p1130"), file.number("/parameters/p1131")};
  const RampSlopes off3{slope("/parameters/p1135"), slope("/parameters/p1135")};
  const std::vector<double>& times = file.table.abscissa();
  const std::vector<double>& targets = file.table.column("n_set_rpm");
  const std::vector<double>& slope_column = file.table.column("acc_rpm_s");
  const double stop = file.number("/stimulus/t_off3");
  RampFunctionGenerator ramp;
  reference::Table ours{{"t_s", "n_rfg_rpm"}};

  for (std::size_t i = 0; i < times.size(); ++i) {
    const RampSlopes& slopes = times[i] >= stop ? off3 : setpoint;
    ramp.step(0.0, targets[i] * kRpm, slopes);  // plans, so that the slope is that from now on
    ours.append({times[i], ramp.output() / kRpm});
    const bool at_its_end =
        std::abs(times[i] - 14.6) < 1e-6;  // where the slope jumps, the reference's is the old one
    if (!at_its_end) {
      EXPECT_NEAR(ramp.acceleration() / kRpm, slope_column[i], 1e-6 * 1300.0) << times[i];
    }
    for (int k = 0; k < 80; ++k) ramp.step(kStep, targets[i] * kRpm, slopes);
  }

  reference::expect_agreement(file, ours, reference::Band::Target);
}

TEST(RampFunctionGenerator, TakesHalfTheRoundingTimesLonger) {
  RampFunctionGenerator ramp;

  EXPECT_NEAR(steps_to(ramp, 1500.0, kRounded) * kStep, 1500.0 / 300.0 + 1.5, 2.0 * kStep);
}

TEST(RampFunctionGenerator, DoesNotReachItsFullSlopeInASmallChange) {
  RampFunctionGenerator ramp;
  double steepest = 0.0;
  double time = 0.0;

  for (; ramp.output() != 100.0; time += kStep) {
    ramp.step(kStep, 100.0, kRounded);
    steepest = std::max(steepest, ramp.acceleration());
    ASSERT_LT(time, 10.0);
  }

  EXPECT_NEAR(steepest, std::sqrt(2.0 * 300.0 * 100.0 / 3.0), 0.1);
  EXPECT_NEAR(time, std::sqrt(2.0 * 100.0 * 3.0 / 300.0), 2.0 * kStep);
}

TEST(RampFunctionGenerator, ChangesItsSlopeByTheRoundingOnlyWhateverTheTargetDoes) {
  const unsigned seed = 20261121;
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> speed{-1000.0, 1000.0};
  RampFunctionGenerator ramp;
  double target = 0.0;
  double slope_before = 0.0;

  for (int i = 0; i < 400'000; ++i) {
    if (i % 4000 == 0) target = speed(random);
    const double before = ramp.output();
    ramp.step(kStep, target, kRounded);
    ASSERT_LE(std::abs(ramp.acceleration() - slope_before), 300.0 * kStep * 1.0001);
    ASSERT_LE(std::abs(ramp.acceleration()), 300.0 * 1.0001);
    ASSERT_NEAR(ramp.output() - before, 0.5 * (slope_before + ramp.acceleration()) * kStep,
                1e-9 + 300.0 * kStep * kStep);
    slope_before = ramp.acceleration();
  }
  steps_to(ramp, target, kRounded);
  EXPECT_EQ(ramp.output(), target);
}

/// Highest output after the target falls from 1000 to @p lower while the ramp runs at 500.
double highest_after_the_target_fell(double lower, RoundingType type) {
  RampSlopes slopes = kRounded;
  slopes.type = type;
  RampFunctionGenerator ramp;
  while (ramp.output() < 500.0) ramp.step(kStep, 1000.0, slopes);
  double highest = ramp.output();
  for (int i = 0; i < 80'000; ++i) highest = std::max(highest, ramp.step(kStep, lower, slopes));
  EXPECT_EQ(ramp.output(), lower);
  return highest;
}

TEST(RampFunctionGenerator, RunsPastATargetThatComesBackWithContinuousRoundingOnly) {
  // The slope of 300 vanishes in 2 s: 300 rad/s further.
  EXPECT_NEAR(highest_after_the_target_fell(400.0, RoundingType::Continuous), 800.0, 0.5);
  EXPECT_NEAR(highest_after_the_target_fell(600.0, RoundingType::Continuous), 800.0, 0.5);
  EXPECT_NEAR(highest_after_the_target_fell(400.0, RoundingType::Discontinuous), 500.0, 0.5);
  EXPECT_NEAR(highest_after_the_target_fell(600.0, RoundingType::Discontinuous), 600.0, 1e-9);
}

TEST(RampFunctionGenerator, PassesZeroRoundedWithoutAJumpOfTheSlope) {
  RampFunctionGenerator ramp;
  ramp.start(300.0);
  const RampSlopes slopes{100.0, 300.0, 1.0, 1.0};
  double slope_before = 0.0;

  for (int i = 0; i < 200'000 && ramp.output() != -300.0; ++i) {
    ramp.step(kStep, -300.0, slopes);
    ASSERT_LE(std::abs(ramp.acceleration() - slope_before), 300.0 * kStep * 1.001);
    slope_before = ramp.acceleration();
  }

  EXPECT_EQ(ramp.output(), -300.0);
}

TEST(RampFunctionGenerator, SaysItsSlopeForThePrecontrol) {
  RampFunctionGenerator ramp;
  const RampSlopes slopes{ramp_slope(750.0, kRampTime), ramp_slope(750.0, kRampTime)};

  ramp.step(kStep, 100.0, slopes);
  EXPECT_DOUBLE_EQ(ramp.acceleration(), 75.0);
  steps_to(ramp, 100.0, slopes);

  EXPECT_EQ(ramp.acceleration(), 0.0);
}

TEST(RampFunctionGenerator, TakesALongStepAsManyShortOnes) {
  RampFunctionGenerator once;
  RampFunctionGenerator often;

  for (int i = 0; i < 32'000; ++i) often.step(kStep, -1000.0, kRounded);
  once.step(32'000 * kStep, -1000.0, kRounded);

  EXPECT_NEAR(once.output(), often.output(), 1e-9);
}

}  // namespace
}  // namespace drive
