#include "cia402/modes/profile/profile_position.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/cia402/profile/positioned_axis.hpp"

namespace cia402 {
namespace {

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

TEST(ProfilePosition, AcknowledgesUntilReachedIfItIsTo) {
  PositionedAxis axis;
  axis.settings.option_code = 1U << 4U;
  axis.give(500.0);
  axis.write(kEnabled);
  axis.run(100);
  EXPECT_TRUE(axis.acknowledges());
  axis.give(600.0, kImmediately);  // ignored
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 500.0);
  EXPECT_FALSE(axis.acknowledges());

  axis.settings.option_code = 2U << 4U;
  axis.give(200.0);
  axis.run_until_reached();
  axis.run(100);
  EXPECT_TRUE(axis.acknowledges());
  axis.write(kEnabled);
  EXPECT_FALSE(axis.acknowledges());

  axis.give(300.0);
  axis.write(kEnabled);
  axis.run_until_reached();
  EXPECT_TRUE(axis.acknowledges());
  axis.write(kEnabled | kNewSetPoint);
  EXPECT_TRUE(axis.acknowledges());
  axis.write(kEnabled);
  EXPECT_FALSE(axis.acknowledges());
  axis.run(1000);
  EXPECT_EQ(axis.position(), 300.0);
}

TEST(ProfilePosition, ClipsItsTargetAtASoftwareLimit) {
  PositionedAxis axis;
  axis.limits.software = Span{-50.0, 400.0};
  axis.give(500.0);
  axis.cycle();
  EXPECT_TRUE(axis.demand.is_limited);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 400.0);
  axis.give(-20.0, kRelative);
  axis.run_until_reached();
  EXPECT_FALSE(axis.demand.is_limited);
  EXPECT_EQ(axis.position(), 380.0);
  axis.give(-51.0);
  axis.run_until_reached();
  EXPECT_TRUE(axis.demand.is_limited);
  EXPECT_EQ(axis.position(), -50.0);
}

TEST(ProfilePosition, KeepsTheCapsOfTheAxis) {
  PositionedAxis axis;
  axis.limits = {.velocity = 400.0, .acceleration = 2000.0, .deceleration = 1000.0};
  axis.give(1000.0);
  axis.cycle();
  EXPECT_TRUE(axis.demand.is_limited);
  EXPECT_DOUBLE_EQ(axis.velocity(), 2.0);
  axis.run(1000);
  EXPECT_DOUBLE_EQ(axis.velocity(), 400.0);
  const double braking = axis.run_until([&] { return axis.position() >= 920.0; });
  axis.run(200);
  EXPECT_NEAR(axis.velocity(), 200.0, 1.0) << braking;
  axis.run_until_reached();
  EXPECT_FALSE(axis.demand.is_limited);
}

TEST(ProfilePosition, ReportsAFollowingErrorThatWasFoundOutside) {
  const PositionedAxis axis;
  EXPECT_FALSE(axis.mode.bits(false).bit_13);
  EXPECT_TRUE(axis.mode.bits(true).bit_13);
}

TEST(ProfilePosition, HoldsOnTheWayWithoutVelocity) {
  PositionedAxis axis;
  axis.settings.velocity = 0.0;
  axis.give(500.0);
  axis.run(100);
  EXPECT_EQ(axis.position(), 0.0);
  EXPECT_FALSE(axis.is_reached());
  axis.settings.velocity = 1000.0;
  axis.give(500.0, kImmediately);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 500.0);
}

TEST(ProfilePosition, GoesToWhereItStands) {
  for (const std::int16_t profile : {std::int16_t{0}, std::int16_t{3}}) {
    PositionedAxis axis{7.0};
    axis.settings.motion_profile = profile;
    axis.give(7.0);
    EXPECT_FALSE(axis.is_reached());
    axis.cycle();
    EXPECT_TRUE(axis.is_reached());
    EXPECT_EQ(axis.position(), 7.0);
  }
}

}  // namespace
}  // namespace cia402
