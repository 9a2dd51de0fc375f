#include "drive/positioning/profile/motion_generator.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace drive {
namespace {

using Event = TrapezoidProfile::Event;

/// 1000 LU/s in 0.1 s, back to rest in 0.2 s: 50 LU and 100 LU.
constexpr MotionLimits kLimits{1000.0, 10000.0, 5000.0};

MotionGenerator placed(double position, double jerk_time) {
  MotionGenerator motion{true};
  motion.place(position);
  motion.set_jerk_time(jerk_time);
  return motion;
}

/// Cycles until it stands.
int cycles_to_rest(MotionGenerator& motion) {
  int cycles = 0;
  for (; !motion.stands() && cycles < 100'000; ++cycles) motion.advance(kMotionCycle);
  return cycles;
}

TEST(MotionGenerator, IsTheTrapezoidWithoutJerkLimiting) {
  MotionGenerator motion = placed(0.0, 0.0);
  motion.move_to(500.0, kLimits);

  for (int i = 0; i < 700; ++i) {
    motion.advance(kMotionCycle);
    ASSERT_EQ(motion.position(), motion.unlimited().position());
    ASSERT_EQ(motion.velocity(), motion.unlimited().velocity());
    ASSERT_EQ(motion.acceleration(), motion.unlimited().acceleration());
    ASSERT_FALSE(motion.is_smoothing());
  }
  EXPECT_TRUE(motion.stands());
}

TEST(MotionGenerator, TakesTheTimeOfTheJerkLimitingLonger) {
  MotionGenerator motion = placed(0.0, 0.25);
  motion.move_to(500.0, kLimits);

  EXPECT_EQ(cycles_to_rest(motion), 650 + 250);
  EXPECT_EQ(motion.position(), 500.0);
  EXPECT_EQ(motion.velocity(), 0.0);
  EXPECT_FALSE(motion.is_smoothing());
}

TEST(MotionGenerator, TellsThatItSmoothesUntilTheMeanHasArrived) {
  MotionGenerator motion = placed(0.0, 0.1);
  motion.move_to(500.0, kLimits);
  motion.advance(kMotionCycle);
  EXPECT_TRUE(motion.is_smoothing());
  while (!motion.unlimited().stands()) motion.advance(kMotionCycle);

  EXPECT_FALSE(motion.stands());
  EXPECT_TRUE(motion.is_smoothing());
  EXPECT_LT(motion.position(), 500.0);
  EXPECT_EQ(cycles_to_rest(motion), 100);
  EXPECT_FALSE(motion.is_smoothing());
}

TEST(MotionGenerator, ChangesItsJerkTimeAtStandstillOnly) {
  MotionGenerator motion = placed(0.0, 0.1);
  motion.move_to(500.0, kLimits);
  motion.set_jerk_time(0.05);  // nothing has moved yet
  EXPECT_DOUBLE_EQ(motion.jerk_time(), 0.05);
  motion.advance(kMotionCycle);
  motion.set_jerk_time(0.0);
  EXPECT_DOUBLE_EQ(motion.jerk_time(), 0.05);
  while (!motion.unlimited().stands()) motion.advance(kMotionCycle);
  EXPECT_DOUBLE_EQ(motion.jerk_time(), 0.05);
  cycles_to_rest(motion);
  EXPECT_EQ(motion.jerk_time(), 0.0);
}

TEST(MotionGenerator, RoundsItsJerkTimeUpToCyclesAndToASecondAtMost) {
  MotionGenerator motion = placed(0.0, 0.0201);
  EXPECT_DOUBLE_EQ(motion.jerk_time(), 0.021);
  motion.set_jerk_time(0.003 * 7.0);
  EXPECT_DOUBLE_EQ(motion.jerk_time(), 0.021);
  motion.set_jerk_time(1e-9);
  EXPECT_DOUBLE_EQ(motion.jerk_time(), 0.001);
  motion.set_jerk_time(2.0);
  EXPECT_DOUBLE_EQ(motion.jerk_time(), 1.0);
  motion.set_jerk_time(-1.0);
  EXPECT_EQ(motion.jerk_time(), 0.0);
}

TEST(MotionGenerator, HasNoJerkLimitingWithoutMemory) {
  MotionGenerator motion{false};
  motion.place(0.0);
  motion.set_jerk_time(0.1);
  motion.move_to(500.0, kLimits);

  EXPECT_EQ(motion.jerk_time(), 0.0);
  EXPECT_EQ(cycles_to_rest(motion), 650);
}

TEST(MotionGenerator, KeepsTheMeanWhenOrdersDivideACycle) {
  MotionGenerator whole = placed(0.0, 0.1);
  MotionGenerator divided = placed(0.0, 0.1);
  whole.move_to(500.3, kLimits);
  divided.move_to(500.3, kLimits);

  for (int i = 0; i < 800; ++i) {
    whole.advance(kMotionCycle);
    for (double left = kMotionCycle; left > 0.0;) left = divided.advance(left, true, true).left;
    ASSERT_NEAR(whole.position(), divided.position(), 1e-9);
  }
  EXPECT_EQ(divided.position(), 500.3);
}

TEST(MotionGenerator, ShiftsPlaceTargetAndMeanTogether) {
  MotionGenerator moved = placed(0.0, 0.1);
  MotionGenerator still = placed(0.0, 0.1);
  moved.move_to(500.0, kLimits);
  still.move_to(500.0, kLimits);

  for (int i = 0; i < 800; ++i) {
    if (i == 60 || i == 700) moved.shift(360000.0);
    moved.advance(kMotionCycle);
    still.advance(kMotionCycle);
    ASSERT_NEAR(moved.position() - still.position(), i < 60 ? 0.0 : i < 700 ? 360000.0 : 720000.0, 1e-9);
    ASSERT_EQ(moved.velocity(), still.velocity());
  }
  EXPECT_EQ(moved.unlimited().target(), 720500.0);
  EXPECT_EQ(moved.position(), 720500.0);
}

TEST(MotionGenerator, ChangesItsAccelerationByNoMoreThanTheJerkWhateverIsOrdered) {
  const unsigned seed = 20261123;
  SCOPED_TRACE(seed);
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> targets{-2000.0, 2000.0};
  constexpr double kJerkTime = 0.04;
  MotionGenerator motion = placed(0.0, kJerkTime);
  double acceleration = 0.0;

  for (int i = 0; i < 300'000; ++i) {
    if (i % 173 == 0) motion.move_to(std::round(targets(random)), kLimits);
    motion.advance(kMotionCycle);
    ASSERT_LE(std::abs(motion.velocity()), kLimits.velocity * (1.0 + 1e-9));
    ASSERT_LE(std::abs(motion.acceleration()), kLimits.acceleration * (1.0 + 1e-9));
    // The trapezoid's acceleration jumps by at most 20000 LU/s² and, at the start of the window, as much once
    // more.
    const double jerk = 2.0 * kLimits.acceleration / kJerkTime;
    ASSERT_LE(std::abs(motion.acceleration() - acceleration), 2.0 * jerk * kMotionCycle);
    acceleration = motion.acceleration();
  }
}

/// ∫ of the position over a cycle that @p profile goes on by, by Simpson's rule (LU s).
double area_of_cycle(TrapezoidProfile& profile) {
  constexpr int kParts = 20;
  constexpr double kPart = kMotionCycle / kParts;
  double area = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double start = profile.position();
    profile.advance(0.5 * kPart);
    const double middle = profile.position();
    profile.advance(0.5 * kPart);
    area += (start + 4.0 * middle + profile.position()) * kPart / 6.0;
  }
  return area;
}

TEST(MotionGenerator, IsTheMeanOfItsTrapezoidWhateverIsOrdered) {
  const unsigned seed = 20261123;
  SCOPED_TRACE(seed);
  std::mt19937_64 random{seed};
  std::uniform_real_distribution<double> targets{-2000.0, 2000.0};
  constexpr std::size_t kCycles = 37;
  MotionGenerator motion = placed(0.0, kCycles * kMotionCycle);
  TrapezoidProfile profile = motion.unlimited();
  std::deque<double> areas(kCycles, 0.0);

  for (int i = 0; i < 20'000; ++i) {
    if (i % 173 == 0) {
      const double target = targets(random);
      motion.move_to(target, kLimits);
      profile.move_to(target, kLimits);
    }
    if (i % 173 == 101) {
      motion.brake(kLimits.deceleration);
      profile.brake(kLimits.deceleration);
    }
    motion.advance(kMotionCycle);
    areas.pop_front();
    areas.push_back(area_of_cycle(profile));
    const double mean = std::accumulate(areas.begin(), areas.end(), 0.0) / (kCycles * kMotionCycle);
    ASSERT_NEAR(motion.position(), mean, 1e-7) << i;
  }
}

TEST(MotionGenerator, StopsWithinACycleAndGoesOnWithTheRest) {
  MotionGenerator motion = placed(0.0, 0.0);
  motion.move_to(500.3, kLimits);
  double left = 0.0;
  for (Event event = Event::None; event == Event::None;) {
    const auto advance = motion.advance(kMotionCycle, true);
    event = advance.event;
    left = advance.left;
  }
  EXPECT_NEAR(left, 0.0007, 1e-9);  // of the cycle in which the cruise ends, after 450.3 ms
  motion.move_to(1000.0, kLimits);
  EXPECT_EQ(motion.advance(left).left, 0.0);
  EXPECT_NEAR(motion.position(), 400.3 + 0.7, 1e-9);
}

}  // namespace
}  // namespace drive
