#include "cia402/modes/profile/profile_position.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/cia402/profile/positioned_axis.hpp"

namespace cia402 {
namespace {

TEST(ProfilePosition, IsReachedAndStandsWhereItIsEnteredAtRest) {
  PositionedAxis axis{123.25};
  EXPECT_TRUE(axis.is_reached());
  EXPECT_FALSE(axis.acknowledges());
  axis.run(100);
  EXPECT_TRUE(axis.is_reached());
  EXPECT_EQ(axis.position(), 123.25);
  EXPECT_EQ(axis.demand.lead, Lead::Position);
}

TEST(ProfilePosition, DoesNotMoveByAnOldSetPoint) {
  PositionedAxis axis;
  axis.give(500.0);
  axis.give(900.0);
  axis.run(100);
  axis.mode.leave();
  EXPECT_FALSE(axis.acknowledges());
  axis.demand.motion = {.position = 40.0};
  axis.mode.enter(axis.demand.motion);
  axis.settings.target = 700.0;
  axis.run(1000);
  EXPECT_EQ(axis.position(), 40.0);
  axis.write(axis.word);  // bit 4 is 1, but it does not rise
  axis.run(1000);
  EXPECT_EQ(axis.position(), 40.0);
  EXPECT_FALSE(axis.acknowledges());
}

TEST(ProfilePosition, BrakesAMotionThatItIsEnteredWith) {
  PositionedAxis axis{0.0, 1000.0};
  EXPECT_FALSE(axis.is_reached());
  axis.cycle();
  EXPECT_DOUBLE_EQ(axis.velocity(), 995.0);
  axis.run(198);
  EXPECT_FALSE(axis.is_reached());
  axis.run(2);
  EXPECT_DOUBLE_EQ(axis.position(), 100.0);
  EXPECT_EQ(axis.velocity(), 0.0);
  EXPECT_TRUE(axis.is_reached());
}

TEST(ProfilePosition, TakesASetPointInAMotionThatItIsEnteredWith) {
  PositionedAxis axis{0.0, 1000.0};
  axis.give(2000.0);
  axis.cycle();
  EXPECT_DOUBLE_EQ(axis.velocity(), 1000.0);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 2000.0);
}

TEST(ProfilePosition, GoesToATargetByEdgeOnly) {
  PositionedAxis axis;
  axis.settings.target = 500.0;
  axis.run(100);
  EXPECT_EQ(axis.position(), 0.0);
  axis.give(500.0);
  EXPECT_TRUE(axis.acknowledges());
  EXPECT_FALSE(axis.is_reached());
  axis.settings = {.target = 1.0, .position_window = 1.0};  // acts with the next one
  const int cycles = axis.run_until_reached();
  EXPECT_NEAR(cycles, 650, 2);
  EXPECT_EQ(axis.position(), 500.0);
  EXPECT_TRUE(axis.acknowledges());
  axis.write(kEnabled);
  EXPECT_FALSE(axis.acknowledges());
}

TEST(ProfilePosition, IsReachedAfterTheTimeInTheWindow) {
  PositionedAxis axis;
  axis.settings.window_time = 20;
  axis.settings.position_window = 4.0;
  axis.give(500.0);
  Actual actual{};
  const auto run = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) axis.demand = axis.mode.cycle(axis.settings, axis.limits, actual);
  };
  run(1000);
  EXPECT_EQ(axis.position(), 500.0);
  EXPECT_FALSE(axis.is_reached());
  actual.position = 496.0;
  run(20);
  EXPECT_FALSE(axis.is_reached());
  actual.position = 495.9;
  run(1);
  actual.position = 504.0;
  run(20);
  EXPECT_FALSE(axis.is_reached());
  run(1);
  EXPECT_TRUE(axis.is_reached());
  actual.position = 504.1;
  run(1);
  EXPECT_FALSE(axis.is_reached());
}

TEST(ProfilePosition, NeedsNoWindow) {
  PositionedAxis axis;
  axis.settings.position_window.reset();
  axis.give(500.0);
  for (int i = 0; i < 649; ++i) axis.mode.cycle(axis.settings, axis.limits, {});
  EXPECT_FALSE(axis.is_reached());
  axis.mode.cycle(axis.settings, axis.limits, {});
  axis.mode.cycle(axis.settings, axis.limits, {});
  EXPECT_TRUE(axis.is_reached());
}

TEST(ProfilePosition, ShowsEachTargetAMillisecondBeforeTheWaitingOneStarts) {
  PositionedAxis axis;
  axis.give(500.0);
  axis.write(kEnabled);
  axis.run(5);
  axis.give(300.0);
  axis.write(kEnabled);
  EXPECT_TRUE(axis.acknowledges());
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 500.0);
  EXPECT_TRUE(axis.acknowledges());
  axis.cycle();
  EXPECT_FALSE(axis.is_reached());
  EXPECT_FALSE(axis.acknowledges());
  EXPECT_LT(axis.position(), 500.0);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 300.0);
}

TEST(ProfilePosition, DropsTheWaitingOneForOneThatChangesImmediately) {
  PositionedAxis axis;
  axis.give(5000.0);
  axis.write(kEnabled);
  axis.run(300);
  axis.give(6000.0);
  axis.write(kEnabled);
  EXPECT_TRUE(axis.acknowledges());
  axis.give(100.0, kImmediately);
  axis.write(kEnabled);
  EXPECT_FALSE(axis.acknowledges());
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 100.0);
  axis.run(2000);
  EXPECT_EQ(axis.position(), 100.0);
}

TEST(ProfilePosition, KeepsItsSetPointsOverAHalt) {
  PositionedAxis axis;
  axis.give(500.0);
  axis.write(kEnabled);
  axis.give(700.0);
  axis.write(kEnabled);
  axis.run(200);
  axis.halt_and_release();
  EXPECT_TRUE(axis.acknowledges());
  EXPECT_FALSE(axis.is_reached());
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 500.0);
  axis.run(1);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 700.0);
}

TEST(ProfilePosition, TakesNoSetPointInAHalt) {
  PositionedAxis axis;
  axis.settings.target = 500.0;
  axis.write(kEnabled | kHalt);
  axis.write(kEnabled | kHalt | kNewSetPoint);
  EXPECT_FALSE(axis.acknowledges());
  axis.write(kEnabled | kNewSetPoint);
  axis.mode.resume(axis.demand.motion);
  axis.run(100);
  EXPECT_EQ(axis.position(), 0.0);
  axis.write(kEnabled | kHalt);
  axis.write(kEnabled | kNewSetPoint);  // the write that ends the halt gives one
  EXPECT_TRUE(axis.acknowledges());
  axis.mode.resume(axis.demand.motion);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 500.0);
}

TEST(ProfilePosition, EndsTheAcknowledgementInAHalt) {
  PositionedAxis axis;
  axis.give(500.0);
  axis.run(100);
  axis.write(kEnabled | kNewSetPoint | kHalt);
  EXPECT_TRUE(axis.acknowledges());
  axis.write(kEnabled | kHalt);
  EXPECT_FALSE(axis.acknowledges());
}

TEST(ProfilePosition, HoldsWhereItIsReleasedFromAHaltAtRest) {
  PositionedAxis axis;
  axis.give(500.0);
  axis.write(kEnabled);
  axis.run_until_reached();
  axis.demand.motion.position = 490.0;
  axis.halt_and_release();
  axis.run(100);
  EXPECT_EQ(axis.position(), 490.0);
}

TEST(ProfilePosition, GoesOnFromAHaltThatIsReleasedWhileItBrakes) {
  PositionedAxis axis;
  axis.give(500.0);
  axis.write(kEnabled);
  axis.run(200);
  axis.demand.motion = {.position = 180.0, .velocity = 700.0};
  axis.mode.resume(axis.demand.motion);
  axis.cycle();
  EXPECT_DOUBLE_EQ(axis.velocity(), 710.0);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 500.0);
  axis.mode.resume({.position = 500.0, .velocity = 100.0});
  axis.run(20);
  EXPECT_EQ(axis.position(), 501.0);
  EXPECT_EQ(axis.velocity(), 0.0);
}

TEST(ProfilePosition, ReportsAFollowingErrorThatWasFoundOutside) {
  const PositionedAxis axis;
  EXPECT_FALSE(axis.mode.bits(false).bit_13);
  EXPECT_TRUE(axis.mode.bits(true).bit_13);
}

}  // namespace
}  // namespace cia402
