#include "cia402/motion/braking_motion.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace cia402 {
namespace {

TEST(Braking, RampsToRestAndHoldsThere) {
  for (const double sign : {1.0, -1.0}) {
    BrakingMotion braking;
    braking.ramp({.position = 10.0, .velocity = sign * 1000.5, .torque = 3.0}, 5000.0);
    EXPECT_FALSE(braking.stands());
    Demand demand = braking.cycle({.torque = 1.5});
    EXPECT_EQ(demand.lead, Lead::Position);
    EXPECT_DOUBLE_EQ(demand.motion.velocity, sign * 995.5);
    EXPECT_DOUBLE_EQ(demand.motion.position, 10.0 + sign * 0.998);
    EXPECT_EQ(demand.motion.torque, 1.5);
    for (int i = 0; i < 199; ++i) demand = braking.cycle({});
    EXPECT_FALSE(braking.stands());
    demand = braking.cycle({});
    EXPECT_TRUE(braking.stands());
    EXPECT_EQ(demand.motion.velocity, 0.0);
    EXPECT_NEAR(demand.motion.position, 10.0 + sign * 1000.5 * 1000.5 / 10000.0, 1e-9);
    const double held = demand.motion.position;
    EXPECT_EQ(braking.cycle({.position = 99.0}).motion.position, held);
  }
}

TEST(Braking, StandsAtOnceWhereNothingMoves) {
  BrakingMotion braking;
  braking.ramp({.position = 5.0}, 100.0);
  EXPECT_TRUE(braking.stands());
  EXPECT_EQ(braking.cycle({.position = 4.0}).motion.position, 5.0);
  braking.stop_hard({.position = 6.0});
  EXPECT_TRUE(braking.stands());
  EXPECT_EQ(braking.cycle({.position = 4.0}).motion.position, 6.0);
  EXPECT_EQ(braking.cycle({.position = 4.0}).lead, Lead::Position);
}

TEST(Braking, StopsHardAndHoldsWhereTheAxisCameToRest) {
  for (const double sign : {1.0, -1.0}) {
    BrakingMotion braking;
    braking.stop_hard({.position = 10.0, .velocity = sign * 1000.0});
    Demand demand = braking.cycle({.position = 11.0, .velocity = sign * 900.0});
    EXPECT_EQ(demand.lead, Lead::Velocity);
    EXPECT_EQ(demand.motion.velocity, 0.0);
    EXPECT_EQ(demand.motion.position, 11.0);
    EXPECT_FALSE(braking.stands());
    demand = braking.cycle({.position = 15.0, .velocity = sign * 11.0});
    EXPECT_FALSE(braking.stands());
    demand = braking.cycle({.position = 15.5, .velocity = sign * -2.0});
    EXPECT_TRUE(braking.stands());
    EXPECT_EQ(demand.lead, Lead::Position);
    EXPECT_EQ(demand.motion.position, 15.5);
    EXPECT_EQ(braking.cycle({.position = 14.0}).motion.position, 15.5);
  }
}

TEST(Braking, TakesTheTorqueBack) {
  for (const double sign : {1.0, -1.0}) {
    BrakingMotion braking;
    braking.release_torque({.torque = sign * 2.05}, 100.0);
    Demand demand = braking.cycle({.position = 3.0, .velocity = 4.0});
    EXPECT_EQ(demand.lead, Lead::Torque);
    EXPECT_DOUBLE_EQ(demand.motion.torque, sign * 1.95);
    EXPECT_EQ(demand.motion.position, 3.0);
    EXPECT_EQ(demand.motion.velocity, 4.0);
    for (int i = 0; i < 19; ++i) demand = braking.cycle({});
    EXPECT_FALSE(braking.stands());
    demand = braking.cycle({});
    EXPECT_TRUE(braking.stands());
    EXPECT_EQ(demand.motion.torque, 0.0);
    braking.release_torque({.torque = sign}, std::numeric_limits<double>::infinity());
    EXPECT_EQ(braking.cycle({}).motion.torque, 0.0);
    EXPECT_TRUE(braking.stands());
  }
}

}  // namespace
}  // namespace cia402
