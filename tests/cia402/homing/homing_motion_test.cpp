// Speeds, ramps and coordinates of homing.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cia402/homing/homing_axis.hpp"

namespace cia402 {
namespace {

/// H, two load revolutions long.
TravelSwitches home_switch(double from = 2.0) {
  TravelSwitches fitted;
  fitted.set(Signal::Home, {.from = from, .to = from + 2.0});
  return fitted;
}

/// Speeds (revolutions/s, signed) that are kept for at least ten cycles, one after the other.
std::vector<double> cruises(HomingAxis& axis) {
  std::vector<double> kept;
  double last = 0.0;
  int since = 0;
  for (int i = 0; i < 20'000 && axis.bits().back() != '1'; ++i) {
    axis.cycle();
    since = axis.speed() == last ? since + 1 : 0;
    last = axis.speed();
    if (since == 10 && (kept.empty() || kept.back() != last)) kept.push_back(last);
  }
  return kept;
}

using Speeds = std::vector<double>;

TEST(HomingSpeed, IsThatForTheSwitchUntilTheEdge) {
  HomingAxis axis{home_switch()};
  axis.start(24);
  EXPECT_EQ(cruises(axis), (Speeds{20.0}));
}

TEST(HomingSpeed, IsThatForZeroAfterTheEdgeInFinalDirection) {
  HomingAxis to_index{home_switch(2.25), 0.5};
  to_index.settings.acceleration = 2000.0 * kTurn;
  to_index.start(8);
  EXPECT_EQ(cruises(to_index), (Speeds{20.0, 2.0}));

  HomingAxis back{home_switch(), 0.5};
  back.start(23);
  EXPECT_EQ(cruises(back), (Speeds{20.0, -2.0}));

  HomingAxis beyond_and_back{home_switch(), 0.5};
  beyond_and_back.start(25);
  EXPECT_EQ(cruises(beyond_and_back), (Speeds{20.0, -2.0}));

  HomingAxis out_of_it{home_switch(), 2.7};
  out_of_it.start(24);
  EXPECT_EQ(cruises(out_of_it), (Speeds{2.0}));
}

TEST(HomingSpeed, IsThatForZeroWhereThereIsOnlyTheIndex) {
  HomingAxis axis{{}, 0.01};
  axis.start(34);
  EXPECT_EQ(cruises(axis), (Speeds{2.0}));
}

TEST(HomingSpeed, IsCappedAndSaysSo) {
  HomingAxis axis{home_switch()};
  axis.limits.velocity = 5.0 * kTurn;
  axis.start(24);
  axis.cycles(100);
  EXPECT_EQ(axis.speed(), 5.0);
  EXPECT_TRUE(axis.is_limited());
  EXPECT_EQ(axis.run(), "000 010 011");
  EXPECT_FALSE(axis.is_limited());
}

TEST(HomingRamp, IsThatOfHoming) {
  HomingAxis axis{home_switch()};
  axis.start(24);
  axis.cycles(51);
  EXPECT_NEAR(axis.speed(), 200.0 * 0.051, 1e-9);
}

TEST(HomingRamp, IsCapped) {
  HomingAxis axis{home_switch(), 1.0};
  axis.limits.acceleration = 50.0 * kTurn;
  axis.limits.deceleration = 80.0 * kTurn;
  axis.start(24);
  axis.cycles(100);
  EXPECT_NEAR(axis.speed(), 5.0, 1e-9);
  while (axis.homing.is_running()) axis.cycle();
  const double before = axis.speed();
  axis.cycle();
  EXPECT_NEAR(axis.speed() - before, -80.0 * 0.001, 1e-9);
}

TEST(HomingRamp, EndsBehindTheEventWhereBrakingEnds) {
  HomingAxis axis{home_switch()};
  axis.start(24);
  EXPECT_EQ(axis.run(), "000 010 011");
  axis.cycles(100);
  const double speed = std::min(20.0, std::sqrt(2.0 * 200.0 * 2.0));
  EXPECT_NEAR(axis.load(), 2.0 + speed * speed / 2.0 / 200.0, 0.05);
}

TEST(HomingEntry, BrakesByTheProfileDeceleration) {
  HomingAxis axis{home_switch()};
  axis.homing.enter({.position = 0.0, .velocity = -3.0 * kTurn});
  axis.settings.deceleration = 30.0 * kTurn;
  const Demand first = axis.homing.cycle(axis.settings, axis.limits, axis.inputs());
  EXPECT_NEAR(first.motion.velocity, (-3.0 + 0.03) * kTurn, 1e-6);
  EXPECT_EQ(first.lead, Lead::Position);
  EXPECT_EQ(axis.bits(), "001");
  Demand last = first;
  for (int i = 0; i < 200; ++i) last = axis.homing.cycle(axis.settings, axis.limits, axis.inputs());
  EXPECT_EQ(last.motion.velocity, 0.0);
  EXPECT_NEAR(last.motion.position, -3.0 * 3.0 / 2.0 / 30.0 * kTurn, 1e-6);
}

TEST(HomingEntry, LetsAMotionComeToRestBeforeThePresentPlaceIsHome) {
  HomingAxis axis{home_switch()};
  axis.start(24);
  axis.cycles(50);
  axis.write(kEnabled);
  axis.start(37);
  ASSERT_GT(axis.speed(), 0.0);
  EXPECT_EQ(axis.run(), "000 011");
  ASSERT_TRUE(axis.home());
  axis.cycles(10);
  EXPECT_NEAR(*axis.home(), static_cast<double>(axis.counts()), 0.001 * kTurn);
}

TEST(HomingCoordinates, HaveHomeAtMinusTheOffset) {
  for (const double offset : {0.0, 1000.0, -123456.5}) {
    HomingAxis axis{home_switch()};
    axis.settings.offset = offset;
    axis.start(24);
    EXPECT_EQ(axis.run(), "000 010 011");
    axis.cycles(10);
    ASSERT_TRUE(axis.home());
    EXPECT_NEAR(axis.position(), static_cast<double>(axis.counts()) - *axis.home() - offset, 1e-9);
    EXPECT_NEAR(axis.demand().position, axis.position(), 1.0) << "the demand has moved with it";
  }
}

TEST(HomingCoordinates, GiveAHomeOnce) {
  HomingAxis axis{home_switch()};
  axis.start(37);
  axis.cycle();
  EXPECT_TRUE(axis.home());
  EXPECT_FALSE(axis.homing.take_home());
}

TEST(HomingCoordinates, AreThoseOfTheNewHomeInTheNextHoming) {
  HomingAxis axis{home_switch()};
  axis.settings.offset = 500.0;
  for (int i = 0; i < 3; ++i) {
    axis.start(24);
    EXPECT_EQ(axis.run(), "000 010 011");
    ASSERT_TRUE(axis.home());
    EXPECT_NEAR(*axis.home(), 2.0 * kTurn, 1e-6) << i;
  }
}

}  // namespace
}  // namespace cia402
