// Set-points that change on the set-point before (bit 9): the axis passes that without a stop.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/cia402/profile/positioned_axis.hpp"

namespace cia402 {
namespace {

/// By 6086h.
class Passing : public testing::TestWithParam<std::int16_t> {
 protected:
  Passing() { axis.settings.motion_profile = GetParam(); }
  /// The axis is on its way to 500 and has @p next waiting.
  void give_two(double next) {
    axis.give(500.0);
    axis.write(kEnabled);
    axis.run(10);
    axis.give(next, kOnSetPoint);
    axis.write(kEnabled);
  }
  /// The velocity in the cycle in which @p place is passed; nothing was reached before.
  double velocity_at(double place) {
    axis.run_until([&] {
      EXPECT_FALSE(axis.is_reached());
      return (axis.position() - place) * axis.velocity() > 0.0;
    });
    return axis.velocity();
  }
  /// To the last target, which is not overshot.
  void expect_end(double target) {
    double furthest = 0.0;
    axis.run_until([&] {
      furthest = std::max(furthest, axis.position());
      return axis.is_reached();
    });
    EXPECT_EQ(axis.position(), target);
    EXPECT_LE(furthest, std::max(500.0, target) + 1e-6);
  }

  PositionedAxis axis{};
};

TEST_P(Passing, KeepsItsVelocity) {
  give_two(2000.0);
  EXPECT_TRUE(axis.acknowledges());
  EXPECT_EQ(velocity_at(500.0), 1000.0);
  EXPECT_FALSE(axis.acknowledges());
  EXPECT_EQ(axis.mode.target(), 2000.0);
  expect_end(2000.0);
}

TEST_P(Passing, HasItsEndVelocity) {
  axis.settings.end_velocity = 200.0;
  give_two(2000.0);
  EXPECT_NEAR(velocity_at(500.0), 200.0, 10.1);
  expect_end(2000.0);
}

TEST_P(Passing, HasNoEndVelocityAboveThatOfTheProfile) {
  axis.settings.end_velocity = 5000.0;
  give_two(2000.0);
  EXPECT_NEAR(velocity_at(500.0), 1000.0, 1e-6);
  expect_end(2000.0);
}

TEST_P(Passing, FallsToTheVelocityOfTheNextOneBehindTheTarget) {
  axis.settings.end_velocity = 0.0;
  axis.give(500.0);
  axis.write(kEnabled);
  axis.settings.velocity = 100.0;
  axis.give(2000.0, kOnSetPoint);
  axis.write(kEnabled);
  EXPECT_NEAR(velocity_at(500.0), 1000.0, 10.0);
  axis.run(1000);
  EXPECT_NEAR(axis.velocity(), 100.0, 1e-9);
  expect_end(2000.0);
}

TEST_P(Passing, IsAsSlowAsTheNextTargetNeeds) {
  give_two(510.0);
  const double velocity = velocity_at(500.0);
  EXPECT_GT(velocity, 0.0);
  EXPECT_LT(velocity, std::sqrt(2.0 * 5000.0 * 10.0) + 1e-6);
  expect_end(510.0);
}

TEST_P(Passing, StopsWhereTheDirectionChanges) {
  give_two(100.0);
  axis.run_until([&] { return axis.mode.target() == 100.0; });
  EXPECT_NEAR(axis.position(), 500.0, 0.01);
  EXPECT_LT(std::abs(axis.velocity()), 11.0);
  expect_end(100.0);
}

TEST_P(Passing, ComesLateIntoBraking) {
  axis.give(500.0);
  axis.write(kEnabled);
  axis.run_until([&] { return axis.position() > 480.0; });
  axis.give(1000.0, kOnSetPoint);
  EXPECT_GT(velocity_at(500.0), 300.0);
  expect_end(1000.0);
}

TEST_P(Passing, GoesOnFromATargetAtWhichTheDemandStands) {
  axis.settings.window_time = 1000;
  axis.give(500.0);
  axis.write(kEnabled);
  axis.run(1200);
  ASSERT_FALSE(axis.is_reached());
  ASSERT_EQ(axis.position(), 500.0);
  axis.give(600.0, kOnSetPoint);
  axis.run(2);
  EXPECT_GT(axis.position(), 500.0);
}

TEST_P(Passing, GoesOnAfterAHalt) {
  give_two(2000.0);
  axis.run(200);
  axis.halt_and_release();
  EXPECT_GT(velocity_at(500.0), 300.0);
  expect_end(2000.0);
}

TEST_P(Passing, ChainsManySmallSteps) {
  axis.give(50.0, kOnSetPoint);
  axis.write(kEnabled);
  int next = 2;
  double slowest = 1e9;
  axis.run_until([&] {
    if (!axis.acknowledges() && next <= 40) {
      axis.give(50.0 * next++, kOnSetPoint);
      axis.write(kEnabled);
    }
    if (axis.position() > 100.0 && axis.position() < 1900.0) slowest = std::min(slowest, axis.velocity());
    return axis.is_reached();
  });
  EXPECT_EQ(axis.position(), 2000.0);
  EXPECT_GT(slowest, 100.0);
}

INSTANTIATE_TEST_SUITE_P(ByProfile, Passing, testing::Values(std::int16_t{0}, std::int16_t{3}));

}  // namespace
}  // namespace cia402
