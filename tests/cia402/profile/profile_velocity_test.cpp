#include "cia402/modes/profile/profile_velocity.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cia402/modes/profile/velocity.hpp"

namespace cia402 {
namespace {

/// An axis whose actual velocity is the demand of the cycle before.
template <class Mode>
struct LedAxis {
  Mode mode{};
  Limits limits{.velocity = 1e6, .acceleration = 1e6, .deceleration = 1e6};
  Actual actual{};
  Demand demand{};

  void take(const Demand& next) {
    const double before = actual.velocity;
    demand = next;
    actual.velocity = demand.motion.velocity;
    if (demand.lead == Lead::Position)
      actual.position = demand.motion.position;
    else
      actual.position += 0.5 * (before + actual.velocity) * kCycle;
  }
};

struct VelocityAxis : LedAxis<ProfileVelocity> {
  ProfileVelocitySettings settings{
      .acceleration = 10000.0, .deceleration = 5000.0, .window = 5.0, .threshold = 5.0};

  explicit VelocityAxis(double velocity = 0.0) {
    actual.velocity = velocity;
    mode.enter({.velocity = velocity});
  }
  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) take(mode.cycle(settings, limits, actual));
  }
  ModeBits bits() const { return mode.bits(settings); }
};

TEST(ProfileVelocity, FollowsItsTargetAlongTheRamps) {
  VelocityAxis axis;
  axis.settings.target = 1000.0;  // written before the entry or after it
  axis.run(50);
  EXPECT_EQ(axis.demand.lead, Lead::Velocity);
  EXPECT_DOUBLE_EQ(axis.demand.motion.velocity, 500.0);
  axis.run(100);
  EXPECT_EQ(axis.demand.motion.velocity, 1000.0);
  axis.settings.target = -100.0;
  axis.run(100);
  EXPECT_NEAR(axis.demand.motion.velocity, 500.0, 1e-9);
  axis.run(105);
  EXPECT_NEAR(axis.demand.motion.velocity, -50.0, 1e-9);
  axis.run(10);
  EXPECT_EQ(axis.demand.motion.velocity, -100.0);
  EXPECT_FALSE(axis.demand.is_limited);
}

TEST(ProfileVelocity, ChangesTheSlopeWhereItPassesStandstill) {
  VelocityAxis axis{2.5};
  axis.settings.target = -100.0;
  axis.run(1);
  EXPECT_DOUBLE_EQ(axis.demand.motion.velocity, -5.0);
}

TEST(ProfileVelocity, TakesTheVelocityOver) {
  VelocityAxis axis{700.0};
  axis.settings.target = 700.0;
  axis.run(10);
  EXPECT_EQ(axis.demand.motion.velocity, 700.0);
  axis.mode.resume({});
  axis.run(1);
  EXPECT_DOUBLE_EQ(axis.demand.motion.velocity, 10.0);
}

TEST(ProfileVelocity, KeepsTheCapsOfTheAxis) {
  VelocityAxis axis;
  axis.limits = {.velocity = 500.0, .acceleration = 1000.0, .deceleration = 2000.0};
  axis.settings.target = -1000.0;
  axis.run(100);
  EXPECT_NEAR(axis.demand.motion.velocity, -100.0, 1e-9);
  EXPECT_TRUE(axis.demand.is_limited);
  axis.run(1000);
  EXPECT_EQ(axis.demand.motion.velocity, -500.0);
  EXPECT_FALSE(axis.bits().bit_10);
  axis.settings.target = 0.0;
  axis.run(100);
  EXPECT_NEAR(axis.demand.motion.velocity, -300.0, 1e-9);
  EXPECT_FALSE(axis.demand.is_limited);
}

TEST(ProfileVelocity, IsReachedAfterTheTimeInTheWindow) {
  VelocityAxis axis;
  axis.settings.target = 100.0;
  axis.settings.window_time = 5;
  EXPECT_FALSE(axis.bits().bit_10);
  axis.run(10);  // at 100; the axis was told so in the last cycle
  axis.run(5);
  EXPECT_FALSE(axis.bits().bit_10);
  axis.run(1);
  EXPECT_TRUE(axis.bits().bit_10);
  axis.settings.target = 120.0;
  EXPECT_FALSE(axis.bits().bit_10);  // before the next cycle
}

TEST(ProfileVelocity, TellsSpeedZero) {
  VelocityAxis axis;
  axis.settings.threshold_time = 3;
  EXPECT_TRUE(axis.bits().bit_12);
  axis.settings.target = 100.0;
  axis.run(2);  // the axis has 10 in the second
  EXPECT_TRUE(axis.bits().bit_12);
  axis.run(3);
  EXPECT_FALSE(axis.bits().bit_12);
  axis.settings.target = 0.0;
  axis.run(100);
  EXPECT_TRUE(axis.bits().bit_12);
  EXPECT_TRUE(axis.bits().bit_10);
  EXPECT_FALSE(VelocityAxis{100.0}.bits().bit_12);
}

TEST(ProfileVelocity, StandsOnASoftwareLimitAndGoesAway) {
  for (const double sign : {1.0, -1.0}) {
    VelocityAxis axis;
    axis.limits.software = Span{-300.0, 300.0};
    axis.settings.target = sign * 1000.0;
    double furthest = 0.0;
    for (int i = 0; i < 2000; ++i) {
      const double before = axis.demand.motion.velocity;
      axis.run(1);
      furthest = std::max(furthest, std::abs(axis.actual.position));
      ASSERT_LE(std::abs(axis.demand.motion.velocity - before), 10.0 + 1e-9);
    }
    EXPECT_EQ(axis.demand.lead, Lead::Position);
    EXPECT_EQ(axis.demand.motion.position, sign * 300.0);
    EXPECT_LE(furthest, 300.0 + 1e-9);
    EXPECT_TRUE(axis.demand.is_limited);
    EXPECT_FALSE(axis.bits().bit_10);
    EXPECT_TRUE(axis.bits().bit_12);
    axis.settings.target = -sign * 200.0;
    axis.run(1);
    EXPECT_EQ(axis.demand.lead, Lead::Velocity);
    EXPECT_DOUBLE_EQ(axis.demand.motion.velocity, -sign * 10.0);
    EXPECT_FALSE(axis.demand.is_limited);
  }
}

TEST(ProfileVelocity, ChangesItsVelocityOnTheWayToALimit) {
  VelocityAxis axis;
  axis.limits.software = Span{-300.0, 300.0};
  axis.settings.target = 1000.0;
  axis.run(330);
  ASSERT_EQ(axis.demand.lead, Lead::Position);
  axis.settings.target = 50.0;
  axis.run(2000);
  EXPECT_EQ(axis.demand.motion.position, 300.0);
  axis.settings.target = 0.0;
  axis.run(10);
  EXPECT_FALSE(axis.demand.is_limited);
  EXPECT_EQ(axis.actual.velocity, 0.0);
  axis.limits.software = Span{-300.0, 400.0};
  axis.settings.target = 100.0;
  axis.run(5000);
  EXPECT_EQ(axis.demand.motion.position, 400.0);
  axis.limits.software.reset();
  axis.run(100);
  EXPECT_EQ(axis.demand.motion.velocity, 100.0);
}

TEST(ProfileVelocity, DoesNotGoOnBeyondALimit) {
  VelocityAxis axis;
  axis.actual.position = 350.0;
  axis.limits.software = Span{-300.0, 300.0};
  axis.settings.target = 1000.0;
  axis.run(100);
  EXPECT_EQ(axis.demand.motion.position, 350.0);
  EXPECT_TRUE(axis.demand.is_limited);
  axis.settings.target = -100.0;
  axis.run(100);
  EXPECT_EQ(axis.demand.motion.velocity, -100.0);
  VelocityAxis fast{1000.0};
  fast.actual.position = 350.0;
  fast.limits.software = Span{-300.0, 300.0};
  fast.settings.target = 1000.0;
  fast.run(300);
  EXPECT_NEAR(fast.demand.motion.position, 450.0, 1e-6);
  EXPECT_EQ(fast.demand.motion.velocity, 0.0);
}

TEST(ProfileVelocity, BrakesHarderIfTheLimitComesTooNear) {
  VelocityAxis axis{1000.0};
  axis.actual.position = 250.0;
  axis.limits.software = Span{-300.0, 300.0};
  axis.settings.target = 1000.0;
  axis.run(200);
  EXPECT_EQ(axis.demand.motion.position, 300.0);
}

struct SlowAxis : LedAxis<Velocity> {
  static constexpr std::uint16_t kRun = 0x007F;
  VelocitySettings settings{.maximum = 1000.0, .slopes = {.acceleration = 10000.0, .deceleration = 5000.0}};
  std::uint16_t word = kRun;

  void run(int cycles) {
    for (int i = 0; i < cycles; ++i) take(mode.cycle(word, settings, limits, actual));
  }
};

TEST(VelocityMode, FollowsItsTargetAlongTheRamps) {
  SlowAxis axis;
  axis.mode.enter({.velocity = 100.0});
  axis.settings.target = 500.0;
  axis.run(10);
  EXPECT_NEAR(axis.demand.motion.velocity, 200.0, 1e-9);
  EXPECT_EQ(axis.demand.lead, Lead::Velocity);
  axis.run(100);
  EXPECT_EQ(axis.demand.motion.velocity, 500.0);
  axis.settings.target = -500.0;
  axis.run(20);
  EXPECT_NEAR(axis.demand.motion.velocity, 400.0, 1e-9);
  EXPECT_EQ(axis.mode.bits(), ModeBits{});
}

TEST(VelocityMode, KeepsTheAmountsBetweenItsLimits) {
  SlowAxis axis;
  axis.settings.minimum = 50.0;
  for (const auto& [target, velocity, limited] :
       {std::tuple{2000.0, 1000.0, true}, std::tuple{-2000.0, -1000.0, true}, std::tuple{20.0, 50.0, false},
        std::tuple{-20.0, -50.0, false}, std::tuple{0.0, 50.0, false}, std::tuple{70.0, 70.0, false}}) {
    axis.settings.target = target;
    axis.run(1000);
    EXPECT_EQ(axis.demand.motion.velocity, velocity);
    EXPECT_EQ(axis.demand.is_limited, limited);
  }
  axis.limits.velocity = 500.0;
  axis.settings.target = 700.0;
  axis.run(1000);
  EXPECT_EQ(axis.demand.motion.velocity, 500.0);
  EXPECT_TRUE(axis.demand.is_limited);
}

TEST(VelocityMode, ObeysTheBitsOfTheRamp) {
  SlowAxis axis;
  axis.settings.target = 500.0;
  axis.word = 0x000F;
  axis.run(100);
  EXPECT_EQ(axis.demand.motion.velocity, 0.0);
  axis.word = SlowAxis::kRun;
  axis.run(30);
  EXPECT_NEAR(axis.demand.motion.velocity, 300.0, 1e-9);
  axis.word = SlowAxis::kRun & ~VelocityBits::kUnlockRamp;
  axis.run(30);
  EXPECT_NEAR(axis.demand.motion.velocity, 300.0, 1e-9);
  axis.word = SlowAxis::kRun & ~VelocityBits::kReferenceRamp;
  axis.run(20);
  EXPECT_NEAR(axis.demand.motion.velocity, 200.0, 1e-9);
  axis.run(100);
  EXPECT_EQ(axis.demand.motion.velocity, 0.0);
  axis.word = SlowAxis::kRun;
  axis.run(100);
  axis.word = SlowAxis::kRun & ~VelocityBits::kEnableRamp;
  axis.run(1);
  EXPECT_EQ(axis.demand.motion.velocity, 0.0);
  axis.word = SlowAxis::kRun;
  axis.run(1);
  EXPECT_NEAR(axis.demand.motion.velocity, 10.0, 1e-9);
}

TEST(VelocityMode, StandsOnASoftwareLimit) {
  SlowAxis axis;
  axis.limits.software = Span{-300.0, 300.0};
  axis.settings.target = 1000.0;
  axis.run(2000);
  EXPECT_EQ(axis.demand.motion.position, 300.0);
  EXPECT_TRUE(axis.demand.is_limited);
}

}  // namespace
}  // namespace cia402
