// csp with the speed cap and the software limits.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/position_rig.hpp"
#include "tests/cia402/random_numbers.hpp"

namespace cia402 {
namespace {

TEST(SpeedCap, LeadsTheDemandUntilItHasCaughtUp) {
  PositionRig rig;
  rig.limits.velocity = 10'000.0;
  rig.set_point(250.0, 0ms);  // 25 ms with the cap
  EXPECT_TRUE(rig.is_limited());
  EXPECT_FALSE(rig.follows());
  EXPECT_EQ(rig.mode.demand().motion.velocity, 10'000.0);
  EXPECT_NEAR(rig.position_at(10ms), 100.0, 1e-9);
  EXPECT_NEAR(rig.position_at(24ms), 240.0, 1e-9);
  EXPECT_EQ(rig.velocity_at(24ms), 10'000.0);
  EXPECT_FALSE(rig.follows());
  EXPECT_NEAR(rig.position_at(25ms), 250.0, 1e-9);
  EXPECT_EQ(rig.position_at(26ms), 250.0);
  EXPECT_EQ(rig.velocity_at(26ms), 0.0);
  EXPECT_FALSE(rig.is_limited());
  EXPECT_TRUE(rig.follows());
}

TEST(SpeedCap, IsNotMetByALineAsSteep) {
  PositionRig rig;
  rig.limits.velocity = 10'000.0;
  rig.set_point(100.0, 300us);
  EXPECT_FALSE(rig.is_limited());
  for (TimeNs time = 1ms; time <= 12ms; time += 1ms) {
    rig.timeline.run_to(time);
    EXPECT_FALSE(rig.is_limited());
    EXPECT_TRUE(rig.follows());
  }
}

TEST(SpeedCap, IsMetInBothDirections) {
  PositionRig rig;
  rig.limits.velocity = 10'000.0;
  rig.set_point(-250.0, 0ms);
  EXPECT_NEAR(rig.position_at(10ms), -100.0, 1e-9);
  EXPECT_EQ(rig.velocity_at(10ms), -10'000.0);
  EXPECT_TRUE(rig.is_limited());
}

TEST(SpeedCap, IsLeftWithASetPointThatIsNearEnough) {
  PositionRig rig;
  rig.limits.velocity = 10'000.0;
  rig.settings.is_supervised = true;
  rig.set_point(150.0, 0ms);
  rig.set_point(180.0, 10ms);  // from 100 on
  EXPECT_FALSE(rig.is_limited());
  EXPECT_TRUE(rig.follows());
  EXPECT_NEAR(rig.mode.demand().motion.velocity, 8000.0, 1e-6);
  EXPECT_NEAR(rig.position_at(15ms), 140.0, 1e-9);
}

TEST(SpeedCap, ThatFallsIsCaughtUpWhenItRises) {
  PositionRig rig;
  rig.limits.velocity = 10'000.0;
  rig.settings.period = 20ms;
  rig.set_point(160.0, 0ms);  // 8 a ms
  EXPECT_NEAR(rig.position_at(4ms), 32.0, 1e-9);
  rig.limits.velocity = 3000.0;
  EXPECT_NEAR(rig.position_at(8ms), 44.0, 1e-9);
  EXPECT_TRUE(rig.is_limited());
  rig.limits.velocity = 10'000.0;
  EXPECT_NEAR(rig.position_at(17ms), 134.0, 1e-9);  // 20 behind, 2 nearer each ms
  EXPECT_TRUE(rig.is_limited());
  EXPECT_NEAR(rig.position_at(18ms), 144.0, 1e-9);
  EXPECT_NEAR(rig.position_at(19ms), 152.0, 1e-9);
  EXPECT_FALSE(rig.is_limited());
  EXPECT_NEAR(rig.velocity_at(19ms), 8000.0, 1e-6);
  EXPECT_EQ(rig.position_at(20ms), 160.0);
}

TEST(SpeedCap, IsTheSlopeOfWhatIsExtrapolated) {
  PositionRig rig;
  rig.limits.velocity = 10'000.0;
  rig.settings.is_supervised = true;
  rig.set_point(150.0, 0ms);
  EXPECT_NEAR(rig.position_at(20ms), 200.0, 1e-9);
  EXPECT_TRUE(rig.is_limited());
  EXPECT_NEAR(rig.velocity_at(21ms), 8000.0, 1e-6);  // 6085h from the cap on
  EXPECT_FALSE(rig.is_limited());
  EXPECT_FALSE(rig.follows());
}

struct SoftwareLimits : testing::Test {
  SoftwareLimits() { rig.limits.software = Span{-100.0, 50.0}; }

  PositionRig rig;
};

TEST_F(SoftwareLimits, ClipTheDemand) {
  rig.set_point(100.0, 0ms);
  EXPECT_NEAR(rig.position_at(4ms), 40.0, 1e-9);
  EXPECT_TRUE(rig.follows());
  EXPECT_FALSE(rig.is_limited());
  EXPECT_EQ(rig.position_at(6ms), 50.0);
  EXPECT_EQ(rig.velocity_at(6ms), 0.0);
  EXPECT_TRUE(rig.is_limited());
  EXPECT_FALSE(rig.follows());
  EXPECT_EQ(rig.position_at(100ms), 50.0);
  EXPECT_TRUE(rig.is_limited());
}

TEST_F(SoftwareLimits, AreLeftWithTheNextSetPointWithin) {
  rig.set_point(100.0, 0ms);
  rig.timeline.run_to(20ms);
  rig.set_point(120.0, 20ms);
  EXPECT_TRUE(rig.is_limited());
  EXPECT_EQ(rig.mode.demand().motion.velocity, 0.0);
  rig.set_point(-50.0, 25ms);
  EXPECT_FALSE(rig.is_limited());
  EXPECT_TRUE(rig.follows());
  EXPECT_NEAR(rig.position_at(30ms), 0.0, 1e-9);
}

TEST_F(SoftwareLimits, MayBeReachedExactly) {
  rig.set_point(-100.0, 0ms);
  EXPECT_EQ(rig.position_at(20ms), -100.0);
  EXPECT_FALSE(rig.is_limited());
  EXPECT_TRUE(rig.follows());
  rig.set_point(-100.0, 20ms);
  EXPECT_FALSE(rig.is_limited());
}

TEST_F(SoftwareLimits, AreNotJumpedToFromOutside) {
  rig.mode.enter({.position = 200.0}, kEnabled);
  EXPECT_EQ(rig.position_at(5ms), 200.0);
  rig.set_point(300.0, 5ms);
  EXPECT_EQ(rig.position_at(10ms), 200.0);
  EXPECT_TRUE(rig.is_limited());
  rig.set_point(0.0, 10ms);
  EXPECT_NEAR(rig.position_at(15ms), 100.0, 1e-9);
  EXPECT_FALSE(rig.is_limited());
  EXPECT_EQ(rig.position_at(20ms), 0.0);
}

TEST_F(SoftwareLimits, EndABraking) {
  rig.mode.enter({.position = 45.0, .velocity = 4500.0}, kEnabled);
  EXPECT_NEAR(rig.position_at(1ms), 49.0, 1e-9);
  EXPECT_EQ(rig.position_at(2ms), 50.0);
  EXPECT_EQ(rig.velocity_at(2ms), 0.0);
}

TEST_F(SoftwareLimits, HoldWhatIsExtrapolated) {
  rig.settings.is_supervised = true;
  rig.set_point(45.0, 0ms);
  rig.timeline.run_to(12ms);
  EXPECT_EQ(rig.mode.demand().motion.position, 50.0);
  EXPECT_TRUE(rig.is_limited());
  EXPECT_EQ(rig.position_at(500ms), 50.0);
}

TEST(PositionDemand, KeepsItsLimitsWithoutAJump) {
  RandomNumbers random;
  PositionRig rig;
  rig.limits.software = Span{-3e5, 3e5};
  Motion before{};
  for (int i = 0; i < 200'000; ++i) {
    const TimeNs start = rig.timeline.now();
    if (random.by_chance(0.02)) rig.limits.velocity = std::pow(10.0, random.between(4.0, 8.0));
    if (random.by_chance(0.02)) rig.settings.period = TimeNs{random.whole(1'000'000, 40'000'000)};
    if (random.by_chance(0.02)) rig.settings.is_supervised = random.by_chance(0.5);
    if (random.by_chance(0.1)) rig.set_point(random.between(-4e5, 4e5), start + TimeNs{random.whole(0, 999'999)});
    rig.timeline.run_to(start + 1ms);
    const Demand& demand = rig.timeline.demands().back();
    const double way = demand.motion.position - before.position;
    ASSERT_LE(std::abs(way),
              std::max(rig.limits.velocity, std::abs(before.velocity)) * 1e-3 * (1.0 + 1e-6) + 1e-6);
    ASSERT_LE(std::abs(demand.motion.position), 3e5);
    ASSERT_LE(std::abs(demand.motion.velocity), std::max(rig.limits.velocity, std::abs(before.velocity)));
    ASSERT_FALSE(rig.follows() && demand.is_limited);
    before = demand.motion;
  }
}

}  // namespace
}  // namespace cia402
