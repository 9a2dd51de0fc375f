// What a set-point of profile position is made of, and within what limits it leads.
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/cia402/profile/positioned_axis.hpp"

namespace cia402 {
namespace {

TEST(SetPoint, AddsWaysToWhatTheOptionsSay) {
  PositionedAxis axis;
  axis.give(100.0, kRelative);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 100.0);
  axis.give(1000.0);
  axis.write(kEnabled);
  axis.run(200);  // at 250
  axis.give(500.0, kRelative | kImmediately);
  axis.run(1);
  EXPECT_EQ(axis.mode.target(), 1500.0);
  const double demand = axis.position();
  axis.settings.option_code = 1;
  axis.give(500.0, kRelative | kImmediately);
  axis.run(1);
  EXPECT_DOUBLE_EQ(axis.mode.target(), demand + 500.0);
  axis.settings.option_code = 2;
  axis.give(500.0, kRelative | kImmediately);
  axis.demand = axis.mode.cycle(axis.settings, axis.limits, {.position = 77.0});
  EXPECT_DOUBLE_EQ(axis.mode.target(), 577.0);
}

TEST(SetPoint, AddsUpWaysThatComeInOneCycle) {
  PositionedAxis axis;
  axis.run(1);
  for (int i = 0; i < 3; ++i) axis.give(100.0, kRelative | kImmediately);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 300.0);
  axis.give(100.0, kRelative);
  axis.write(kEnabled);
  axis.give(50.0, kRelative);
  axis.run_until_reached();
  axis.run(2);
  axis.run_until_reached();
  EXPECT_EQ(axis.position(), 450.0);
}

TEST(SetPoint, AcknowledgesUntilReachedIfItIsTo) {
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

TEST(SetPoint, ClipsItsTargetAtASoftwareLimit) {
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

TEST(SetPoint, KeepsTheCapsOfTheAxis) {
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

TEST(SetPoint, HoldsOnTheWayWithoutVelocity) {
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

TEST(SetPoint, GoesToWhereItStands) {
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
