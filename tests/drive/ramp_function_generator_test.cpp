#include "drive/ramp_function_generator.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace drive
