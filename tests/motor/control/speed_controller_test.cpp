#include "motor/control/speed_controller.hpp"

#include <gtest/gtest.h>

namespace motor {
namespace {

constexpr TorqueLimits kLimits{10.0, -5.0};

SpeedController<> controller() {
  SpeedController<> result;
  result.configure({.proportional = 0.5, .integral_time = 0.02}, 0.002, 125e-6);
  return result;
}

TEST(SpeedController, StaysWithinBothTorqueLimitsAndSaysSo) {
  SpeedController<> speed = controller();

  EXPECT_EQ(speed.step(1000.0, 0.0, kLimits), 10.0);
  EXPECT_TRUE(speed.limited());
  EXPECT_EQ(speed.step(-1000.0, 0.0, kLimits), -5.0);
  EXPECT_TRUE(speed.limited());
  speed.step(0.0, 0.0, kLimits);
  EXPECT_FALSE(speed.limited());
}

TEST(SpeedController, IntegratesNothingWhileItIsLimited) {
  SpeedController<> speed = controller();
  for (int i = 0; i < 8000; ++i) speed.step(1000.0, 0.0, kLimits);

  EXPECT_NEAR(speed.step(0.0, 0.0, kLimits), 0.0, 1e-9);
}

TEST(SpeedController, IntegratesALoadUntilTheSpeedIsRight) {
  SpeedController<> speed = controller();
  speed.reset(100.0);
  double torque = 0.0;

  for (int i = 0; i < 160; ++i) torque = speed.step(100.0, 99.0, kLimits);  // one integral time

  EXPECT_GT(torque, 0.8);
  EXPECT_LT(torque, 1.1);
}

TEST(SpeedController, FollowsALimitThatIsLoweredWhileItHoldsALoad) {
  SpeedController<> speed = controller();
  speed.reset(100.0);
  for (int i = 0; i < 8000; ++i) speed.step(100.0, 99.0, kLimits);

  EXPECT_EQ(speed.step(100.0, 100.0, {2.0, -2.0}), 2.0);
  EXPECT_EQ(speed.step(100.0, 100.0, {10.0, -5.0}), 2.0);
}

TEST(SpeedController, CrossedLimitsGiveTheLowerOne) {
  SpeedController<> speed = controller();

  EXPECT_EQ(speed.step(1000.0, 0.0, {-3.0, -1.0}), -1.0);
}

TEST(SpeedController, IsEmptyAfterAReset) {
  SpeedController<> speed = controller();
  speed.reset(100.0);
  for (int i = 0; i < 8000; ++i) speed.step(100.0, 99.0, kLimits);
  ASSERT_GT(speed.step(100.0, 100.0, kLimits), 5.0);

  speed.reset(100.0);

  EXPECT_FALSE(speed.limited());
  EXPECT_EQ(speed.step(100.0, 100.0, kLimits), 0.0);
}

}  // namespace
}  // namespace motor
