#include "cia402/modes/profile/profile_torque.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace cia402 {
namespace {

struct TorqueAxis {
  ProfileTorque mode{};
  ProfileTorqueSettings settings{.slope = 1000.0};
  Demand demand{};

  explicit TorqueAxis(double torque = 0.0) { mode.enter({.torque = torque}); }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) demand = mode.cycle(settings, {.position = 3.0, .velocity = 4.0});
  }
  bool is_reached() const { return mode.bits(settings).bit_10; }
};

TEST(ProfileTorque, FollowsItsTargetAlongTheSlope) {
  TorqueAxis axis;
  EXPECT_TRUE(axis.is_reached());
  axis.settings.target = 10.0;
  EXPECT_FALSE(axis.is_reached());
  axis.run(4);
  EXPECT_EQ(axis.demand.lead, Lead::Torque);
  EXPECT_DOUBLE_EQ(axis.demand.motion.torque, 4.0);
  EXPECT_EQ(axis.demand.motion.position, 3.0);
  EXPECT_EQ(axis.demand.motion.velocity, 4.0);
  axis.run(5);
  EXPECT_FALSE(axis.is_reached());
  axis.run(1);
  EXPECT_TRUE(axis.is_reached());
  EXPECT_EQ(axis.demand.motion.torque, 10.0);
  axis.settings.target = -5.0;
  axis.run(12);
  EXPECT_NEAR(axis.demand.motion.torque, -2.0, 1e-12);
  axis.settings.slope = 100.0;
  axis.run(10);
  EXPECT_NEAR(axis.demand.motion.torque, -3.0, 1e-12);
}

TEST(ProfileTorque, TakesTheTorqueOver) {
  TorqueAxis axis{7.0};
  axis.settings.target = 5.0;
  axis.run(1);
  EXPECT_DOUBLE_EQ(axis.demand.motion.torque, 6.0);
  axis.mode.resume({});
  axis.run(2);
  EXPECT_DOUBLE_EQ(axis.demand.motion.torque, 2.0);
}

TEST(ProfileTorque, HasTheSlopeInTheMiddleOfASineSquare) {
  TorqueAxis axis;
  axis.settings = {.target = 100.0, .slope = 1000.0, .profile = 1};
  double steepest = 0.0;
  double before = 0.0;
  for (int i = 0; i < 157; ++i) {
    axis.run(1);
    steepest = std::max(steepest, axis.demand.motion.torque - before);
    before = axis.demand.motion.torque;
  }
  EXPECT_NEAR(steepest, 1.0, 1e-3);
  EXPECT_FALSE(axis.is_reached());
  axis.run(1);
  EXPECT_TRUE(axis.is_reached());
}

}  // namespace
}  // namespace cia402
