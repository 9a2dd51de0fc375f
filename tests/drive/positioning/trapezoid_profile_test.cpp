#include "drive/positioning/profile/trapezoid_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace drive {
namespace {

using Event = TrapezoidProfile::Event;

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kCycle = 1e-3;
/// 1000 LU/s in 0.1 s, back to rest in 0.2 s: 50 LU and 100 LU.
constexpr MotionLimits kLimits{1000.0, 10000.0, 5000.0};

TrapezoidProfile placed(double position) {
  TrapezoidProfile profile;
  profile.place(position);
  return profile;
}

/// From now on until it stands (s).
double time_to_rest(TrapezoidProfile& profile) {
  const double much = 10.0;
  return much - profile.advance(much, false, true).left;
}

TEST(TrapezoidProfile, RisesCruisesFallsAndEndsAtItsTarget) {
  TrapezoidProfile profile = placed(-30.0);
  profile.move_to(470.0, kLimits);

  profile.advance(0.05);
  EXPECT_DOUBLE_EQ(profile.velocity(), 500.0);
  EXPECT_DOUBLE_EQ(profile.position(), -30.0 + 12.5);
  EXPECT_EQ(profile.acceleration(), 10000.0);
  profile.advance(0.25);
  EXPECT_EQ(profile.velocity(), 1000.0);
  EXPECT_DOUBLE_EQ(profile.position(), -30.0 + 50.0 + 200.0);
  EXPECT_EQ(profile.acceleration(), 0.0);
  EXPECT_FALSE(profile.has_passed_braking_point());
  profile.advance(0.25);
  EXPECT_NEAR(profile.velocity(), 500.0, 1e-9);
  EXPECT_NEAR(profile.acceleration(), -5000.0, 1e-6);
  EXPECT_TRUE(profile.has_passed_braking_point());
  EXPECT_FALSE(profile.stands());
  EXPECT_NEAR(time_to_rest(profile), 0.1, 1e-12);
  EXPECT_EQ(profile.position(), 470.0);
  EXPECT_EQ(profile.velocity(), 0.0);
  EXPECT_EQ(profile.acceleration(), 0.0);
  EXPECT_TRUE(profile.stands());
  EXPECT_TRUE(profile.has_arrived());
}

TEST(TrapezoidProfile, StopsAtTheBrakingPointWithTheTimeThatIsLeft) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(500.0, kLimits);

  const auto braking = profile.advance(1.0, true, true);
  EXPECT_EQ(braking.event, Event::BrakingPoint);
  EXPECT_NEAR(braking.left, 1.0 - 0.1 - 0.35, 1e-12);
  EXPECT_NEAR(profile.position(), 400.0, 1e-9);
  EXPECT_EQ(profile.velocity(), 1000.0);
  const auto standstill = profile.advance(braking.left, true, true);
  EXPECT_EQ(standstill.event, Event::Standstill);
  EXPECT_NEAR(standstill.left, braking.left - 0.2, 1e-12);
  EXPECT_EQ(profile.advance(standstill.left, true, true).event, Event::None);
}

TEST(TrapezoidProfile, BrakesAtThePeakWhereThereIsNoCruise) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(-15.0, kLimits);

  const auto braking = profile.advance(1.0, true);

  EXPECT_EQ(braking.event, Event::BrakingPoint);
  EXPECT_NEAR(profile.velocity(), -std::sqrt(2.0 * 10000.0 * 5000.0 * 15.0 / 15000.0), 1e-9);
  EXPECT_NEAR(profile.position(), -5.0, 1e-12);
}

TEST(TrapezoidProfile, HasBothEventsWhereItStandsAlready) {
  TrapezoidProfile profile = placed(42.0);
  profile.move_to(42.0, kLimits);

  const auto braking = profile.advance(kCycle, true, true);
  const auto standstill = profile.advance(braking.left, true, true);

  EXPECT_EQ(braking.event, Event::BrakingPoint);
  EXPECT_EQ(standstill.event, Event::Standstill);
  EXPECT_EQ(standstill.left, kCycle);
  EXPECT_TRUE(profile.has_arrived());
  EXPECT_EQ(profile.position(), 42.0);
}

TEST(TrapezoidProfile, TellsOfTheBrakingPointOfEveryOrderAndStaysOnTheCurve) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(500.0, kLimits);
  ASSERT_EQ(profile.advance(1.0, true).event, Event::BrakingPoint);

  for (int i = 1; i <= 199; ++i) {
    profile.move_to(500.0, kLimits);
    ASSERT_TRUE(profile.has_passed_braking_point());
    const auto told = profile.advance(kCycle, true);
    ASSERT_EQ(told.event, Event::BrakingPoint);
    ASSERT_EQ(told.left, kCycle);
    profile.advance(told.left);
    ASSERT_NEAR(profile.velocity(), 1000.0 - 5.0 * i, 1e-6);
  }
  profile.advance(2.0 * kCycle);

  EXPECT_TRUE(profile.has_arrived());
  EXPECT_EQ(profile.position(), 500.0);
}

TEST(TrapezoidProfile, DoesNotTellOfABrakingPointThatAnotherOrderHasMoved) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(0.0, kLimits);
  profile.move_to(500.0, kLimits);
  EXPECT_EQ(profile.advance(0.2, true).event, Event::None);
  EXPECT_EQ(profile.velocity(), 1000.0);
}

TEST(TrapezoidProfile, FallsToALowerVelocityWithTheDeceleration) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(kEndless, kLimits);
  profile.advance(1.0);

  profile.move_to(kEndless, {400.0, 10000.0, 5000.0});
  EXPECT_EQ(profile.acceleration(), -5000.0);
  profile.advance(0.06);
  EXPECT_DOUBLE_EQ(profile.velocity(), 700.0);
  profile.advance(0.06);
  EXPECT_EQ(profile.velocity(), 400.0);
  EXPECT_EQ(profile.target(), kEndless);
  EXPECT_FALSE(profile.stands());
}

TEST(TrapezoidProfile, BrakesAndReversesToATargetThatIsTooNear) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(kEndless, kLimits);
  profile.advance(0.1 + 0.1);  // at 150 LU
  profile.move_to(240.0, kLimits);
  double furthest = 0.0;

  while (!profile.stands()) {
    profile.advance(kCycle);
    furthest = std::max(furthest, profile.position());
  }

  EXPECT_NEAR(furthest, 250.0, 0.01);
  EXPECT_EQ(profile.position(), 240.0);
}

TEST(TrapezoidProfile, HoldsOnTheWayAndGoesOn) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(1000.0, kLimits);
  profile.advance(0.2);
  profile.move_to(1000.0, {0.0, 10000.0, 5000.0});

  EXPECT_NEAR(time_to_rest(profile), 0.2, 1e-12);
  EXPECT_TRUE(profile.holds());
  EXPECT_TRUE(profile.stands());
  EXPECT_FALSE(profile.has_arrived());
  EXPECT_DOUBLE_EQ(profile.position(), 250.0);
  EXPECT_EQ(profile.target(), 1000.0);

  profile.move_to(1000.0, kLimits);
  EXPECT_FALSE(profile.stands());
  EXPECT_NEAR(time_to_rest(profile), 0.1 + 0.6 + 0.2, 1e-12);
  EXPECT_EQ(profile.position(), 1000.0);
}

TEST(TrapezoidProfile, BrakesToRestWhereverThatIs) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(-kEndless, kLimits);
  profile.advance(0.2);
  profile.brake(10000.0);

  EXPECT_DOUBLE_EQ(profile.target(), -200.0);
  const auto advance = profile.advance(1.0, true, true);
  EXPECT_EQ(advance.event, Event::Standstill);
  EXPECT_NEAR(advance.left, 0.9, 1e-12);
  EXPECT_DOUBLE_EQ(profile.position(), -200.0);
  EXPECT_EQ(profile.target(), profile.position());
  EXPECT_TRUE(profile.stands());
  EXPECT_FALSE(profile.has_arrived());
  EXPECT_FALSE(profile.has_passed_braking_point());
}

TEST(TrapezoidProfile, GoesOnFromWhereAnotherMotionLeftIt) {
  TrapezoidProfile profile;
  profile.place(0.25, -1000.0);
  EXPECT_FALSE(profile.stands());
  profile.advance(0.1);
  EXPECT_DOUBLE_EQ(profile.position(), -99.75);
  EXPECT_EQ(profile.velocity(), -1000.0);

  profile.move_to(-500.0, kLimits);
  EXPECT_NEAR(time_to_rest(profile), 0.30025 + 0.2, 1e-12);
  EXPECT_EQ(profile.position(), -500.0);
  profile.place(3.0, 500.0);
  profile.brake(5000.0);
  EXPECT_NEAR(time_to_rest(profile), 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(profile.position(), 28.0);
  profile.place(7.0, 0.0);
  EXPECT_TRUE(profile.stands());
}

TEST(TrapezoidProfile, KeepsTheLargerDecelerationOnlyWhereTheNewOneWouldReverse) {
  TrapezoidProfile profile = placed(0.0);
  profile.move_to(kEndless, kLimits);
  profile.advance(0.2);  // at 150 LU; 100 LU to rest
  const MotionLimits gentle{1000.0, 10000.0, 2500.0};

  EXPECT_TRUE(profile.can_reach(250.0, 5000.0));
  EXPECT_FALSE(profile.can_reach(249.0, 5000.0));
  EXPECT_FALSE(profile.can_reach(250.0, 2500.0));
  TrapezoidProfile far = profile;
  far.move_to(400.0, gentle, true);
  EXPECT_EQ(far.limits().deceleration, 2500.0);
  profile.move_to(300.0, gentle, true);
  EXPECT_EQ(profile.limits().deceleration, 5000.0);
  profile.move_to(160.0, gentle, true);
  profile.advance(0.25);
  EXPECT_LT(profile.velocity(), 0.0);
  EXPECT_EQ(profile.limits().deceleration, 2500.0);
}

TEST(TrapezoidProfile, LosesNothingInTenMillionRevolutionsOfAModuloAxis) {
  constexpr double kRange = 10000.0;
  TrapezoidProfile profile = placed(0.25);
  profile.move_to(-kEndless, {1e8, 1e9, 1e9});
  profile.advance(0.1);  // at its velocity
  const double start = profile.position();
  double turns = 0.0;

  for (int i = 0; i < 1'000'000; ++i) {  // ten revolutions each
    profile.advance(kCycle);
    const double turn = std::floor(profile.position() / kRange);
    profile.shift(-turn * kRange);
    turns += turn;
    ASSERT_GE(profile.position(), 0.0);
    ASSERT_LT(profile.position(), kRange);
  }

  EXPECT_NEAR(turns * kRange + profile.position() - start, -1e11, 1e-3);
  const double target = std::floor(profile.position()) - 1e9;
  profile.move_to(target, {1e8, 1e9, 1e9});
  profile.shift(1e10);
  profile.advance(100.0);
  EXPECT_EQ(profile.position(), target + 1e10);
}

TEST(TrapezoidProfile, EndsExactlyAtTheEndsOfTheRangeOfPositions) {
  for (const double target : {2147482647.0, -2147482648.0, 0.001, 1e12}) {
    TrapezoidProfile profile = placed(-1234567.875);
    profile.move_to(target, {1e9, 1e7, 3e6});
    profile.advance(1e5);
    EXPECT_EQ(profile.position(), target);
    EXPECT_TRUE(profile.has_arrived());
  }
}

TEST(TrapezoidProfile, HasNumbersWhateverItIsGiven) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MotionLimits limits : {MotionLimits{nan, nan, nan}, MotionLimits{1e300, 1e300, 1e300},
                                    MotionLimits{-1.0, -1.0, -1.0}, MotionLimits{100.0, 0.0, 0.0}}) {
    for (const double target : {10.0, nan, kEndless, 1e300}) {
      TrapezoidProfile profile = placed(0.0);
      profile.move_to(1e6, kLimits);
      profile.advance(0.05);
      profile.move_to(target, limits);
      for (int i = 0; i < 100; ++i) profile.advance(kCycle);
      EXPECT_FALSE(std::isnan(profile.position())) << target;
      EXPECT_FALSE(std::isnan(profile.velocity())) << target;
      EXPECT_FALSE(std::isnan(profile.acceleration())) << target;
    }
  }
}

}  // namespace
}  // namespace drive
