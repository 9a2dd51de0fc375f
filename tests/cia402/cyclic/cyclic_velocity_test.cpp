// csv: from set-points to the velocity demand.
#include "cia402/modes/cyclic/cyclic_velocity.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/timeline.hpp"

namespace cia402 {
namespace {

constexpr std::uint16_t kEnabled = 0x000F;
constexpr std::uint16_t kHalted = 0x010F;

/// csv with an axis that does what is demanded, T = 10 ms.
struct CyclicVelocityMode : testing::Test {
  CyclicVelocityMode() { mode.enter({}, kEnabled); }

  Demand cycle() {
    const Demand demand = mode.cycle(settings, limits, actual);
    if (demand.lead == Lead::Velocity) {
      actual.position += 0.5e-3 * (actual.velocity + demand.motion.velocity);
      actual.velocity = demand.motion.velocity;
    }
    return demand;
  }
  void set_point(double velocity, TimeNs time, const Offsets& offsets = {}) {
    mode.set_point(velocity, offsets, timeline.instant(time), settings, limits);
  }
  double velocity_at(TimeNs time) {
    timeline.run_to(time);
    return timeline.demand_at(time).motion.velocity;
  }
  bool follows() const { return mode.bits().bit_12; }

  CyclicSettings settings{.period = 10ms, .deceleration = 1e6, .quick_stop_deceleration = 2e6};
  Limits limits{.velocity = 1e9, .acceleration = 1e9, .deceleration = 1e9};
  Actual actual{};
  CyclicVelocity mode;
  Timeline timeline{[this] { return cycle(); }};
};

TEST_F(CyclicVelocityMode, RunsOnALineToTheSetPoint) {
  set_point(1000.0, 2300us);
  EXPECT_EQ(velocity_at(2ms), 0.0);
  EXPECT_NEAR(velocity_at(3ms), 70.0, 1e-9);
  EXPECT_NEAR(velocity_at(12ms), 970.0, 1e-9);
  EXPECT_EQ(velocity_at(13ms), 1000.0);
  EXPECT_EQ(velocity_at(10s), 1000.0);
  EXPECT_TRUE(follows());
  EXPECT_EQ(timeline.demand_at(10s).lead, Lead::Velocity);
}

TEST_F(CyclicVelocityMode, StartsTheLineAnewFromThePresentDemand) {
  set_point(1000.0, 0ms);
  set_point(-1000.0, 5ms);
  EXPECT_NEAR(mode.demand().motion.velocity, 500.0, 1e-9);
  EXPECT_NEAR(velocity_at(10ms), -250.0, 1e-9);
  EXPECT_EQ(velocity_at(15ms), -1000.0);
}

TEST_F(CyclicVelocityMode, AddsTheVelocityOffset) {
  set_point(1000.0, 0ms, {.position = 77.0, .velocity = -200.0, .torque = 0.3});
  EXPECT_EQ(velocity_at(20ms), 800.0);
  EXPECT_EQ(timeline.demand_at(20ms).velocity_offset, 0.0);
  EXPECT_EQ(timeline.demand_at(20ms).torque_offset, 0.3);
}

TEST_F(CyclicVelocityMode, TellsThePositionOfTheAxis) {
  set_point(1000.0, 0ms);
  timeline.run_to(100ms);
  EXPECT_GT(actual.position, 90.0);
  const double before = actual.position;
  EXPECT_EQ(mode.cycle(settings, limits, actual).motion.position, before);
}

TEST_F(CyclicVelocityMode, HoldsThePositionWhereItIsEnabledAtRest) {
  mode.enter({.position = 500.0}, kEnabled);
  timeline.run_to(10ms);
  EXPECT_EQ(timeline.demand_at(10ms).lead, Lead::Position);
  EXPECT_EQ(timeline.demand_at(10ms).motion.position, 500.0);
  EXPECT_FALSE(follows());
  set_point(0.0, 10ms);
  EXPECT_TRUE(follows());
  EXPECT_EQ(mode.demand().lead, Lead::Velocity);
}

TEST_F(CyclicVelocityMode, TakesOverTheVelocityOfAMotion) {
  settings.is_supervised = true;
  mode.enter({.velocity = 750.0}, kEnabled);
  EXPECT_EQ(velocity_at(1s), 750.0);
  EXPECT_EQ(timeline.demand_at(1s).lead, Lead::Velocity);
  EXPECT_FALSE(follows());
  EXPECT_FALSE(mode.is_lost());
  set_point(250.0, 1s);
  EXPECT_NEAR(velocity_at(1s + 5ms), 500.0, 1e-9);
}

TEST_F(CyclicVelocityMode, IgnoresSetPointsInAHalt) {
  set_point(1000.0, 0ms);
  timeline.run_to(5ms);
  mode.controlword(kHalted);
  EXPECT_FALSE(follows());
  set_point(2000.0, 5ms);
  mode.resume({.position = 40.0});
  timeline.run_to(50ms);
  EXPECT_EQ(timeline.demand_at(50ms).lead, Lead::Position);
  EXPECT_EQ(timeline.demand_at(50ms).motion.position, 40.0);
  EXPECT_FALSE(follows());
  set_point(100.0, 50ms);
  EXPECT_EQ(velocity_at(60ms), 100.0);

  mode.enter({}, kHalted);
  set_point(100.0, 60ms);
  EXPECT_FALSE(follows());
  mode.leave();
  EXPECT_EQ(mode.bits(), ModeBits{});
}

TEST_F(CyclicVelocityMode, HoldsTheVelocityOfAMissingSetPointThenBrakes) {
  settings.is_supervised = true;
  set_point(20'000.0, 0ms);
  EXPECT_EQ(velocity_at(20ms), 20'000.0);
  EXPECT_FALSE(follows());
  EXPECT_NEAR(velocity_at(21ms), 18'000.0, 1e-6);
  EXPECT_NEAR(velocity_at(29ms), 2000.0, 1e-6);
  EXPECT_EQ(velocity_at(30ms), 0.0);
  EXPECT_FALSE(mode.is_lost());
  EXPECT_EQ(velocity_at(31ms), 0.0);
  EXPECT_TRUE(mode.is_lost());
  set_point(100.0, 31ms);
  EXPECT_FALSE(mode.is_lost());
  EXPECT_TRUE(follows());
}

TEST_F(CyclicVelocityMode, FollowsWhileOneSetPointIsLate) {
  settings.is_supervised = true;
  set_point(20'000.0, 0ms);
  EXPECT_EQ(velocity_at(19ms), 20'000.0);
  EXPECT_TRUE(follows());
  set_point(10'000.0, 19ms);
  EXPECT_NEAR(velocity_at(24ms), 15'000.0, 1e-6);
}

TEST_F(CyclicVelocityMode, IsBoundedByTheSpeedCap) {
  limits.velocity = 800.0;
  set_point(1000.0, 0ms);
  EXPECT_NEAR(velocity_at(7ms), 700.0, 1e-9);
  EXPECT_TRUE(follows());
  EXPECT_EQ(velocity_at(9ms), 800.0);
  EXPECT_FALSE(follows());
  EXPECT_TRUE(mode.demand().is_limited);
  EXPECT_EQ(velocity_at(100ms), 800.0);
  set_point(-900.0, 100ms);
  EXPECT_NEAR(velocity_at(105ms), -50.0, 1e-9);  // from 800 on
  EXPECT_TRUE(follows());
  EXPECT_EQ(velocity_at(110ms), -800.0);
  EXPECT_TRUE(mode.demand().is_limited);
}

TEST_F(CyclicVelocityMode, StandsOnASoftwareLimit) {
  for (const double direction : {1.0, -1.0}) {
    limits.software = Span{-1000.0, 1000.0};
    set_point(direction * 40'000.0, timeline.now());
    double fastest = 0.0;
    for (int i = 0; i < 300; ++i) {
      const double before = mode.demand().motion.velocity;
      timeline.run_to(timeline.now() + 1ms);
      const double now = mode.demand().motion.velocity;
      fastest = std::max(fastest, std::abs(now));
      EXPECT_GE(direction * (now - before), -2000.0 * 1.05);  // 6085h
      EXPECT_LE(direction * actual.position, 1000.0 + 1e-6);
    }
    EXPECT_GT(fastest, 30'000.0);
    EXPECT_NEAR(actual.position, direction * 1000.0, 0.5);
    EXPECT_TRUE(mode.demand().is_limited);
    EXPECT_FALSE(follows());
  }
  set_point(5000.0, timeline.now());  // away
  timeline.run_to(timeline.now() + 10ms);
  EXPECT_EQ(mode.demand().motion.velocity, 5000.0);
  EXPECT_TRUE(follows());
}

TEST_F(CyclicVelocityMode, MayComeBackFromBeyondALimit) {
  limits.software = Span{-1000.0, 1000.0};
  actual.position = 1500.0;
  set_point(5000.0, 0ms);
  EXPECT_EQ(velocity_at(20ms), 0.0);
  EXPECT_TRUE(mode.demand().is_limited);
  set_point(-5000.0, 20ms);
  EXPECT_EQ(velocity_at(30ms), -5000.0);
  EXPECT_FALSE(mode.demand().is_limited);
}

TEST_F(CyclicVelocityMode, HasSoftwareLimitsInEveryTurnOfAModuloAxis) {
  limits.range = Span{0.0, 3599.0};
  limits.software = Span{100.0, 3500.0};
  actual.position = 36'000.0 + 3000.0;
  set_point(40'000.0, 0ms);
  timeline.run_to(500ms);
  EXPECT_NEAR(actual.position, 36'000.0 + 3500.0, 0.5);
  set_point(-40'000.0, 500ms);
  timeline.run_to(1s);
  EXPECT_NEAR(actual.position, 36'000.0 + 100.0, 0.5);
}

}  // namespace
}  // namespace cia402
