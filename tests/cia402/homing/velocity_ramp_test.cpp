#include "cia402/modes/homing/velocity_ramp.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "cia402/base/demand.hpp"

namespace cia402 {
namespace {

TEST(VelocityRamp, RisesAndFallsByItsSlopes) {
  VelocityRamp ramp;
  ramp.place(10.0, 0.0);
  for (int i = 0; i < 100; ++i) ramp.advance(50.0, {.acceleration = 1000.0, .deceleration = 500.0});
  EXPECT_EQ(ramp.velocity(), 50.0);
  EXPECT_NEAR(ramp.position(), 10.0 + 50.0 * 0.1 - 50.0 * 50.0 / 2.0 / 1000.0, 1e-9);
  const double from = ramp.position();
  for (int i = 0; i < 200; ++i) ramp.advance(0.0, {.acceleration = 1000.0, .deceleration = 500.0});
  EXPECT_TRUE(ramp.stands());
  EXPECT_NEAR(ramp.position(), from + 50.0 * 50.0 / 2.0 / 500.0, 1e-9);
}

TEST(VelocityRamp, TurnsRoundWithinACycle) {
  VelocityRamp ramp;
  ramp.place(0.0, 1.0);
  ramp.advance(-100.0, {.acceleration = 1000.0, .deceleration = 4000.0});
  // 0.25 ms to rest, 0.75 ms away
  EXPECT_NEAR(ramp.velocity(), -0.75, 1e-12);
  EXPECT_NEAR(ramp.position(), 0.5 * 1.0 * 0.25e-3 - 0.5 * 0.75 * 0.75e-3, 1e-15);
}

TEST(VelocityRamp, KeepsItsVelocity) {
  VelocityRamp ramp;
  ramp.place(0.0, -7.0);
  ramp.advance(-7.0, {.acceleration = 1.0, .deceleration = 1.0});
  EXPECT_EQ(ramp.velocity(), -7.0);
  EXPECT_NEAR(ramp.position(), -7.0 * kCycle, 1e-15);
}

TEST(VelocityRamp, HasNoJumpWhateverIsAsked) {
  constexpr unsigned kSeed = 20270212;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 random{kSeed};
  std::uniform_real_distribution<double> speed{-500.0, 500.0};
  std::uniform_real_distribution<double> slope{1.0, 1e6};
  VelocityRamp ramp;
  ramp.place(0.0, 0.0);
  for (int i = 0; i < 100'000; ++i) {
    const double wanted = random() % 4 == 0 ? 0.0 : speed(random);
    const VelocityRamp::Slopes slopes{slope(random), slope(random)};
    const double steepest = std::max(slopes.acceleration, slopes.deceleration);
    const double position = ramp.position();
    const double velocity = ramp.velocity();
    ramp.advance(wanted, slopes);
    ASSERT_LE(std::abs(ramp.velocity() - velocity), steepest * kCycle * (1.0 + 1e-12));
    ASSERT_GE(ramp.velocity(), std::min(velocity, wanted));
    ASSERT_LE(ramp.velocity(), std::max(velocity, wanted));
    const double way = ramp.position() - position;
    ASSERT_GE(way, std::min(velocity, wanted) * kCycle - 1e-9);
    ASSERT_LE(way, std::max(velocity, wanted) * kCycle + 1e-9);
  }
}

}  // namespace
}  // namespace cia402
