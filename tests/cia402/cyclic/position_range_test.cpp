// csp on an axis with 607Bh.
#include "cia402/quantities/position_range.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/position_rig.hpp"
#include "tests/cia402/random_numbers.hpp"

namespace cia402 {
namespace {

constexpr Span kCircle{0.0, 3599.0};

struct ModuloAxis : testing::Test {
  ModuloAxis() { rig.limits.range = kCircle; }

  /// From the demand to where it is T after @p position came.
  double way_to(double position) {
    const double before = rig.mode.demand().motion.position;
    rig.set_point(position, rig.timeline.now());
    return rig.position_at(rig.timeline.now() + 10ms) - before;
  }

  PositionRig rig;
};

TEST_F(ModuloAxis, GoesTheShorterWay) {
  EXPECT_EQ(way_to(100.0), 100.0);
  EXPECT_EQ(way_to(3500.0), -200.0);
  EXPECT_EQ(way_to(100.0), 200.0);
  EXPECT_EQ(way_to(1900.0), 1800.0);  // half a turn: positive
  EXPECT_EQ(way_to(100.0), 1800.0);
  EXPECT_EQ(way_to(99.0), -1.0);
}

TEST_F(ModuloAxis, TakesPlacesBeyondItsRange) {
  EXPECT_EQ(way_to(3700.0), 100.0);
  EXPECT_EQ(way_to(-3500.0), 0.0);
  EXPECT_EQ(way_to(36'000'050.0), -50.0);
}

TEST_F(ModuloAxis, IsEnteredInAnyTurn) {
  rig.mode.enter({.position = 36'000.0 * 5 + 50.0}, kEnabled);
  EXPECT_EQ(way_to(3599.0), -51.0);
}

TEST_F(ModuloAxis, FollowsAMasterThatWrapsLikeOneThatCountsOn) {
  PositionRig other;
  other.limits.range = kCircle;
  for (int k = 0; k < 1000; ++k) {
    const std::int64_t position = k * 700LL;
    rig.set_point(static_cast<double>(wrapped(position, kCircle)), k * 10ms);
    other.set_point(static_cast<double>(position), k * 10ms);
    ASSERT_EQ(rig.mode.demand().motion.position, other.mode.demand().motion.position);
    ASSERT_EQ(rig.mode.demand().motion.velocity, other.mode.demand().motion.velocity);
  }
  EXPECT_EQ(rig.mode.demand().motion.position, 998.0 * 700.0);
}

TEST_F(ModuloAxis, DoesNotTurnBackWhenTheDemandTrailsByMoreThanHalfATurn) {
  rig.limits.velocity = 100'000.0;  // 1000 a period
  double before = 0.0;
  for (int k = 1; k <= 20; ++k) {
    rig.set_point(static_cast<double>(wrapped(1500LL * k, kCircle)), k * 10ms);
    EXPECT_GE(rig.mode.demand().motion.position, before);
    before = rig.mode.demand().motion.position;
  }
  EXPECT_EQ(rig.position_at(2s), 30'000.0);
  EXPECT_TRUE(rig.follows());
}

TEST_F(ModuloAxis, StaysWithinItsTurnBetweenSoftwareLimits) {
  rig.limits.software = Span{100.0, 3500.0};
  rig.mode.enter({.position = 7200.0 + 3400.0}, kEnabled);
  EXPECT_NEAR(way_to(200.0), -3200.0, 1e-9);
  EXPECT_NEAR(way_to(3600.0 + 200.0), 0.0, 1e-9);
  EXPECT_NEAR(way_to(50.0), -100.0, 1e-9);
  EXPECT_TRUE(rig.is_limited());
  EXPECT_NEAR(way_to(3550.0), 3400.0, 1e-9);
  EXPECT_TRUE(rig.is_limited());
}

TEST_F(ModuloAxis, GetsToEveryPlaceByNoMoreThanHalfATurn) {
  RandomNumbers random;
  rig.limits.range = Span{-720.0, 1439.0};
  for (int i = 0; i < 10'000; ++i) {
    const double target = std::floor(random.between(-1e5, 1e5));
    const double way = way_to(target);
    ASSERT_LE(std::abs(way), 1080.0);
    const double turns = (rig.mode.demand().motion.position - target) / 2160.0;
    ASSERT_EQ(turns, std::round(turns));
  }
}

}  // namespace
}  // namespace cia402
