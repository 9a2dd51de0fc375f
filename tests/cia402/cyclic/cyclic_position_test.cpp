// csp: from set-points to the demand.
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/position_rig.hpp"
#include "tests/cia402/random_numbers.hpp"

namespace cia402 {
namespace {

TEST(CyclicPosition, GetsToTheSetPointAfterTheInterpolationPeriod) {
  PositionRig rig;
  rig.set_point(100.0, 0ms);
  EXPECT_TRUE(rig.follows());
  EXPECT_DOUBLE_EQ(rig.mode.demand().motion.velocity, 10'000.0);
  for (int i = 1; i < 10; ++i) EXPECT_NEAR(rig.position_at(i * 1ms), 10.0 * i, 1e-9);
  EXPECT_DOUBLE_EQ(rig.velocity_at(9ms), 10'000.0);
  EXPECT_EQ(rig.position_at(10ms), 100.0);
  EXPECT_EQ(rig.velocity_at(10ms), 0.0);
}

TEST(CyclicPosition, HoldsTheLastSetPointForEver) {
  PositionRig rig;
  rig.set_point(100.0, 0ms);
  EXPECT_EQ(rig.position_at(10s), 100.0);
  EXPECT_EQ(rig.velocity_at(10s), 0.0);
  EXPECT_TRUE(rig.follows());
  EXPECT_FALSE(rig.mode.is_lost());
}

TEST(CyclicPosition, StartsTheLineAtTheInstantOfTheSetPoint) {
  PositionRig rig;
  rig.set_point(100.0, 2300us);
  EXPECT_EQ(rig.position_at(2ms), 0.0);
  EXPECT_NEAR(rig.position_at(3ms), 7.0, 1e-9);
  EXPECT_NEAR(rig.position_at(12ms), 97.0, 1e-9);
  EXPECT_EQ(rig.position_at(13ms), 100.0);
}

TEST(CyclicPosition, TakesSeveralSetPointsInACycle) {
  PositionRig rig;
  rig.set_point(100.0, 200us);
  rig.set_point(-100.0, 700us);  // from 5 on
  EXPECT_NEAR(rig.mode.demand().motion.position, 5.0, 1e-9);
  EXPECT_NEAR(rig.position_at(1ms), 5.0 - 0.3 * 10.5, 1e-9);
  rig.set_point(100.0, 1ms);
  EXPECT_EQ(rig.position_at(11ms), 100.0);
}

TEST(CyclicPosition, TakesAnInstantThatLiesBackAsNow) {
  PositionRig rig;
  rig.timeline.run_to(5ms);
  rig.mode.set_point(100.0, {}, -3ms, rig.settings, rig.limits);
  rig.mode.set_point(100.0, {}, 7ms, rig.settings, rig.limits);
  EXPECT_NEAR(rig.mode.demand().motion.position, 10.0, 1e-9);
  EXPECT_EQ(rig.position_at(16ms), 100.0);
}

/// The demand that the rule says, computed from one set-point to the next.
double ruled_demand(const std::vector<std::pair<TimeNs, double>>& set_points, TimeNs period, TimeNs time) {
  double from = 0.0;
  double to = 0.0;
  TimeNs since{};
  const auto at = [&](TimeNs now) {
    return now - since >= period ? to : from + (to - from) * seconds(now - since) / seconds(period);
  };
  for (const auto& [instant, value] : set_points) {
    if (instant > time) break;
    from = at(instant);
    to = value;
    since = instant;
  }
  return at(time);
}

TEST(CyclicPosition, FollowsSetPointsAtAllInstantsAsTheRuleSays) {
  RandomNumbers random;
  for (int run = 0; run < 200; ++run) {
    PositionRig rig;
    rig.settings.period = std::chrono::microseconds{random.whole(1000, 30'000)};
    rig.limits.velocity = 1e12;
    std::vector<std::pair<TimeNs, double>> set_points{{TimeNs{}, 0.0}};
    for (int i = 0; i < 100; ++i) {
      const TimeNs time = set_points.back().first + TimeNs{random.whole(0, 20'000'000)};
      set_points.emplace_back(time, random.between(-1e6, 1e6));
    }
    for (const auto& [time, value] : set_points) rig.set_point(value, time);
    rig.timeline.run_to(set_points.back().first + 50ms);
    for (TimeNs time = 1ms; time < rig.timeline.now(); time += 1ms)
      ASSERT_NEAR(rig.timeline.demand_at(time).motion.position,
                  ruled_demand(set_points, rig.settings.period, time), 1e-6);
  }
}

TEST(CyclicPosition, IsSmoothWithJitterOfSync) {
  RandomNumbers random;
  PositionRig rig;
  rig.settings.is_supervised = true;
  rig.settings.missed_set_points = 1;
  constexpr double kVelocity = 1000.0;  // units a set-point
  for (int k = 0; k < 1000; ++k) {
    rig.set_point(kVelocity * k, k * 10ms + TimeNs{random.whole(0, 500'000)});
    ASSERT_FALSE(rig.mode.is_lost());
    ASSERT_TRUE(rig.follows());
    if (k < 2) continue;
    // One T behind, but for the jitter of two instants.
    const double at_set_point = rig.mode.demand().motion.position;
    ASSERT_NEAR(at_set_point, kVelocity * (k - 1), kVelocity * 0.06);
    ASSERT_NEAR(rig.mode.demand().motion.velocity, kVelocity * 100.0, kVelocity * 6.0);
  }
}

TEST(CyclicPosition, TrailsByThePeriodWhenSetPointsComeSooner) {
  PositionRig rig;
  rig.settings.period = 50ms;
  for (int k = 0; k <= 200; ++k) rig.set_point(100.0 * k, k * 10ms);

  // The lag of the recursion d += (s - d) / 5 behind a ramp of 100 a step, before each set-point.
  EXPECT_NEAR(rig.mode.demand().motion.position, 100.0 * 200 - 500.0, 1e-6);
  EXPECT_NEAR(rig.mode.demand().motion.velocity, 10'000.0, 1e-6);
}

TEST(CyclicPosition, TakesThePeriodOfTheSetPoint) {
  PositionRig rig;
  rig.set_point(100.0, 0ms);
  rig.settings.period = 2ms;
  EXPECT_NEAR(rig.position_at(5ms), 50.0, 1e-9);
  rig.set_point(60.0, 5ms);
  EXPECT_EQ(rig.position_at(7ms), 60.0);
}

TEST(CyclicPosition, AddsThePositionOffsetAndFeedsTheOthersForward) {
  PositionRig rig;
  rig.set_point(100.0, 300us, {.position = 7.0, .velocity = 250.0, .torque = -1.5});
  EXPECT_EQ(rig.mode.demand().velocity_offset, 250.0);
  EXPECT_EQ(rig.mode.demand().torque_offset, -1.5);
  EXPECT_EQ(rig.position_at(11ms), 107.0);
  EXPECT_DOUBLE_EQ(rig.velocity_at(5ms), 10'700.0);  // the slope alone
  EXPECT_EQ(rig.timeline.demand_at(11ms).velocity_offset, 250.0);
  EXPECT_EQ(rig.timeline.demand_at(11ms).lead, Lead::Position);
}

TEST(CyclicPosition, HoldsWhereItIsEnabledUntilASetPointComes) {
  PositionRig rig;
  rig.mode.enter({.position = 1234.5}, kEnabled);
  EXPECT_EQ(rig.position_at(100ms), 1234.5);
  EXPECT_FALSE(rig.follows());
  EXPECT_EQ(rig.timeline.demand_at(100ms).velocity_offset, 0.0);
  rig.set_point(2234.5, 100ms);
  EXPECT_TRUE(rig.follows());
  EXPECT_DOUBLE_EQ(rig.position_at(105ms), 1734.5);
}

TEST(CyclicPosition, UsesNoSetPointFromBeforeItsEntry) {
  PositionRig rig;
  rig.set_point(5000.0, 0ms, {.position = 1.0, .velocity = 2.0, .torque = 3.0});
  rig.timeline.run_to(4ms);
  rig.mode.leave();
  rig.set_point(9000.0, 4ms);
  EXPECT_FALSE(rig.follows());
  rig.mode.enter({.position = 2000.0}, kEnabled);
  EXPECT_EQ(rig.position_at(500ms), 2000.0);
  EXPECT_EQ(rig.mode.demand().torque_offset, 0.0);
  EXPECT_FALSE(rig.follows());
}

TEST(CyclicPosition, BrakesAMotionThatItIsEnteredWith) {
  PositionRig rig;
  rig.mode.enter({.position = 0.0, .velocity = 4500.0}, kEnabled);  // 4.5 ms with 6084h
  EXPECT_NEAR(rig.velocity_at(1ms), 3500.0, 1e-9);
  EXPECT_NEAR(rig.position_at(1ms), 4.0, 1e-9);
  EXPECT_NEAR(rig.position_at(5ms), 0.5 * 4500.0 * 4500.0 / 1e6, 1e-9);
  EXPECT_EQ(rig.velocity_at(5ms), 0.0);
  EXPECT_FALSE(rig.follows());
}

TEST(CyclicPosition, BrakesNoHarderThanTheAccelerationCapAllows) {
  PositionRig rig;
  rig.limits.deceleration = 5e5;  // 60C6h
  rig.mode.enter({.velocity = 4500.0}, kEnabled);
  EXPECT_NEAR(rig.velocity_at(1ms), 4000.0, 1e-9);
}

TEST(CyclicPosition, GoesOnFromABrakingDemandWithTheFirstSetPoint) {
  PositionRig rig;
  rig.mode.enter({.velocity = 4500.0}, kEnabled);
  rig.set_point(100.0, 1500us);
  const double start = 4500.0 * 1.5e-3 - 0.5e6 * 1.5e-3 * 1.5e-3;
  EXPECT_NEAR(rig.mode.demand().motion.position, start, 1e-9);
  EXPECT_NEAR(rig.position_at(2ms), start + (100.0 - start) * 0.05, 1e-9);
  EXPECT_EQ(rig.position_at(12ms), 100.0);
}

TEST(CyclicPosition, IgnoresSetPointsFromHaltToRelease) {
  PositionRig rig;
  rig.set_point(100.0, 0ms);
  rig.timeline.run_to(5ms);
  rig.mode.controlword(kHalted);
  EXPECT_FALSE(rig.follows());
  rig.set_point(0.0, 5ms);
  rig.mode.controlword(kEnabled);
  EXPECT_FALSE(rig.follows());
  rig.set_point(0.0, 5ms);
  rig.mode.resume({.position = 75.0});
  EXPECT_FALSE(rig.follows());
  EXPECT_EQ(rig.position_at(50ms), 75.0);
  rig.set_point(175.0, 50ms);
  EXPECT_TRUE(rig.follows());
  EXPECT_DOUBLE_EQ(rig.position_at(55ms), 125.0);
}

TEST(CyclicPosition, IsHaltedFromItsEntryIfTheControlwordSaysSo) {
  PositionRig rig;
  rig.mode.enter({.position = 500.0}, kHalted);
  rig.set_point(0.0, 0ms);
  EXPECT_FALSE(rig.follows());
  EXPECT_EQ(rig.position_at(50ms), 500.0);
  rig.mode.resume({.position = 500.0});
  rig.set_point(600.0, 50ms);
  EXPECT_EQ(rig.position_at(60ms), 600.0);
}

TEST(CyclicPosition, ShowsTheFollowingErrorInBit13AndNothingInBit10) {
  PositionRig rig;
  rig.set_point(100.0, 0ms);
  EXPECT_EQ(rig.mode.bits(false), (ModeBits{.bit_12 = true}));
  EXPECT_EQ(rig.mode.bits(true), (ModeBits{.bit_12 = true, .bit_13 = true}));
  rig.mode.leave();
  EXPECT_EQ(rig.mode.bits(true), ModeBits{});
}

}  // namespace
}  // namespace cia402
