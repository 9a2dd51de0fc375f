#include "drive/positioning/profile/sliding_mean.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace drive {
namespace {

TEST(SlidingMean, IsTheSetpointItselfWhenOff) {
  SlidingMean mean{1000};
  mean.start(0);
  mean.add({5.0, 0.0025}, 5000.0);

  EXPECT_EQ(mean.lag(), 0.0);
  EXPECT_TRUE(mean.is_settled());
}

TEST(SlidingMean, HasNoMoreCyclesThanRoom) {
  SlidingMean mean{20};
  mean.start(30);

  EXPECT_EQ(mean.cycles(), 20U);
}

TEST(SlidingMean, LagsBehindAConstantVelocityByHalfItsTime) {
  SlidingMean mean{100};
  mean.start(100);
  for (int i = 0; i < 100; ++i) mean.add({5.0, 0.0025}, 5000.0);

  EXPECT_NEAR(mean.lag(), 5000.0 * 0.05, 1e-10);
  EXPECT_NEAR(mean.velocity(), 5000.0, 1e-9);
  EXPECT_NEAR(mean.acceleration(), 50000.0, 1e-6);  // the setpoint jumped to its velocity 100 ms ago
  mean.add({5.0, 0.0025}, 5000.0);
  EXPECT_EQ(mean.acceleration(), 0.0);
}

TEST(SlidingMean, SettlesExactlyAfterItsTimeWithoutMotion) {
  SlidingMean mean{7};
  mean.start(7);
  mean.add({0.1, 0.00003}, 100.0);
  mean.add({0.3, 0.00017}, 0.0);
  for (int i = 0; i < 6; ++i) {
    mean.add({}, 0.0);
    EXPECT_FALSE(mean.is_settled());
  }
  EXPECT_GT(std::abs(mean.lag()), 0.0);

  mean.add({}, 0.0);
  EXPECT_TRUE(mean.is_settled());
  EXPECT_EQ(mean.lag(), 0.0);
  EXPECT_EQ(mean.velocity(), 0.0);
  EXPECT_EQ(mean.acceleration(), 0.0);
}

TEST(SlidingMean, DoesNotDriftInALongMotion) {
  constexpr std::size_t kCycles = 137;
  const unsigned seed = 20261123;
  SCOPED_TRACE(seed);
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> ways{0.0, 500.0};
  SlidingMean mean{kCycles};
  mean.start(kCycles);
  std::vector<MotionStretch> latest(kCycles);

  for (std::size_t i = 0; i < 3'000'000; ++i) {
    const double way = ways(random);
    latest[i % kCycles] = {way, 0.4 * way * kMotionCycle};
    mean.add(latest[i % kCycles], way / kMotionCycle);
    if (i % 500'000 != 499'999) continue;
    double behind = 0.0;
    double way_after = 0.0;
    for (std::size_t back = 0; back < kCycles; ++back) {
      const MotionStretch& cycle = latest[(i - back) % kCycles];
      behind += way_after + cycle.way - cycle.area / kMotionCycle;
      way_after += cycle.way;
    }
    EXPECT_NEAR(mean.lag(), behind / kCycles, 1e-9);
    EXPECT_NEAR(mean.velocity(), way_after / (kCycles * kMotionCycle), 1e-6);
  }
}

}  // namespace
}  // namespace drive
