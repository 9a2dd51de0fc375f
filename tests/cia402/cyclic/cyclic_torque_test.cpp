// cst: from set-points to the torque demand.
#include "cia402/modes/cyclic/cyclic_torque.hpp"

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/timeline.hpp"

namespace cia402 {
namespace {

constexpr std::uint16_t kEnabled = 0x000F;
constexpr std::uint16_t kHalted = 0x010F;

struct CyclicTorqueMode : testing::Test {
  CyclicTorqueMode() { mode.enter({}, kEnabled); }

  void set_point(double torque, TimeNs time, const Offsets& offsets = {}) {
    mode.set_point(torque, offsets, timeline.instant(time), settings);
  }
  double torque_at(TimeNs time) {
    timeline.run_to(time);
    return timeline.demand_at(time).motion.torque;
  }
  bool follows() const { return mode.bits().bit_12; }

  CyclicSettings settings{.period = 10ms, .torque_slope = 100.0};
  Actual actual{.position = 12.0, .velocity = 3.0};
  CyclicTorque mode;
  Timeline timeline{[this] { return mode.cycle(settings, actual); }};
};

TEST_F(CyclicTorqueMode, HasTheTorqueOfTheSetPointAtOnce) {
  set_point(2.0, 300us, {.velocity = 50.0, .torque = -0.5});
  EXPECT_EQ(mode.demand().motion.torque, 1.5);
  EXPECT_EQ(mode.demand().lead, Lead::Torque);
  EXPECT_EQ(mode.demand().torque_offset, 0.0);
  EXPECT_EQ(torque_at(1ms), 1.5);
  EXPECT_EQ(torque_at(10s), 1.5);
  EXPECT_TRUE(follows());
  EXPECT_EQ(timeline.demand_at(1ms).motion.position, 12.0);
  EXPECT_EQ(timeline.demand_at(1ms).motion.velocity, 3.0);
}

TEST_F(CyclicTorqueMode, HoldsThePositionWhereItIsEnabledAtRest) {
  mode.enter({.position = 500.0}, kEnabled);
  timeline.run_to(10ms);
  EXPECT_EQ(timeline.demand_at(10ms).lead, Lead::Position);
  EXPECT_EQ(timeline.demand_at(10ms).motion.position, 500.0);
  EXPECT_FALSE(follows());
}

TEST_F(CyclicTorqueMode, TakesOverTheTorqueOfTheModeBefore) {
  settings.is_supervised = true;
  mode.enter({.position = 500.0, .torque = 0.75}, kEnabled);
  EXPECT_EQ(torque_at(1s), 0.75);
  EXPECT_EQ(timeline.demand_at(1s).lead, Lead::Torque);
  EXPECT_FALSE(follows());
  EXPECT_FALSE(mode.is_lost());
}

TEST_F(CyclicTorqueMode, IgnoresSetPointsInAHalt) {
  set_point(2.0, 0ms);
  mode.controlword(kHalted);
  EXPECT_FALSE(follows());
  set_point(3.0, 5ms);
  mode.resume({.position = 40.0, .torque = 0.2});
  timeline.run_to(50ms);
  EXPECT_EQ(timeline.demand_at(50ms).lead, Lead::Position);
  EXPECT_EQ(timeline.demand_at(50ms).motion.position, 40.0);
  set_point(-1.0, 50ms);
  EXPECT_EQ(mode.demand().lead, Lead::Torque);
  EXPECT_EQ(torque_at(51ms), -1.0);

  mode.enter({}, kHalted);
  set_point(1.0, 51ms);
  EXPECT_FALSE(follows());
  mode.leave();
  EXPECT_EQ(mode.bits(), ModeBits{});
}

TEST_F(CyclicTorqueMode, HoldsTheTorqueOfAMissingSetPointThenTakesItAway) {
  settings.is_supervised = true;
  for (const double sign : {1.0, -1.0}) {
    const TimeNs start = timeline.now();
    set_point(sign, start);
    EXPECT_EQ(torque_at(start + 20ms), sign);
    EXPECT_FALSE(follows());
    EXPECT_NEAR(torque_at(start + 21ms), 0.9 * sign, 1e-9);
    EXPECT_NEAR(torque_at(start + 29ms), 0.1 * sign, 1e-9);
    EXPECT_FALSE(mode.is_lost());
    EXPECT_NEAR(torque_at(start + 31ms), 0.0, 1e-9);
    EXPECT_TRUE(mode.is_lost());
    EXPECT_EQ(torque_at(start + 40ms), 0.0);
  }
}

TEST_F(CyclicTorqueMode, FollowsWhileOneSetPointIsLate) {
  settings.is_supervised = true;
  set_point(1.0, 0ms);
  timeline.run_to(19ms);
  EXPECT_TRUE(follows());
  set_point(0.5, 19ms);
  EXPECT_EQ(torque_at(20ms), 0.5);
}

TEST_F(CyclicTorqueMode, IsBoundedByTheTorqueLimits) {
  settings.torque = Span{-1.0, 2.0};
  set_point(3.0, 0ms);
  EXPECT_EQ(mode.demand().motion.torque, 2.0);
  EXPECT_TRUE(mode.demand().is_limited);
  EXPECT_FALSE(follows());
  set_point(-1.0, 1ms);
  EXPECT_EQ(mode.demand().motion.torque, -1.0);
  EXPECT_FALSE(mode.demand().is_limited);
  EXPECT_TRUE(follows());
  set_point(-1.5, 2ms);
  EXPECT_EQ(torque_at(3ms), -1.0);
  settings.torque = Span{-5.0, 2.0};
  EXPECT_EQ(torque_at(4ms), -1.5);
  EXPECT_TRUE(follows());
}

}  // namespace
}  // namespace cia402
