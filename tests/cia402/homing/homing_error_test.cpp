#include <string>

#include <gtest/gtest.h>

#include "tests/cia402/homing/homing_axis.hpp"

namespace cia402 {
namespace {

/// Limit switches at -4 and 8, H from @p from to @p to (load revolutions).
TravelSwitches limits_and_home(double from, double to) {
  TravelSwitches switches;
  switches.set(Signal::NegativeLimit, {.from = -kEndless, .to = -4.0});
  switches.set(Signal::PositiveLimit, {.from = 8.0, .to = kEndless});
  switches.set(Signal::Home, {.from = from, .to = to});
  return switches;
}

TravelSwitches limits() {
  TravelSwitches switches;
  switches.set(Signal::NegativeLimit, {.from = -kEndless, .to = -4.0});
  switches.set(Signal::PositiveLimit, {.from = 8.0, .to = kEndless});
  return switches;
}

void expect_error(HomingAxis& axis, int method, HomingError error) {
  axis.start(method);
  EXPECT_EQ(axis.bits(), "000") << method;
  const std::string seen = axis.run();
  EXPECT_TRUE(seen == "000 101" || seen == "000 100 101") << method << ": " << seen;
  EXPECT_EQ(axis.homing.error(), error) << method;
  EXPECT_FALSE(axis.home()) << method;
  EXPECT_FALSE(axis.homing.is_homed()) << method;
  axis.cycles(200);
  EXPECT_EQ(axis.bits(), "101") << method;
  EXPECT_EQ(axis.demand().velocity, 0.0);
}

TEST(HomingErrors, ComeWithTheStartOfNoMethodAndOfReservedOnes) {
  for (const int method : {0, 15, 16, 31, 32, 38, -1, 127, -128}) {
    HomingAxis axis{limits_and_home(2.0, 4.0)};
    expect_error(axis, method, HomingError::Method);
    EXPECT_EQ(axis.counts(), 0);
  }
}

TEST(HomingErrors, ComeWithALimitSwitchThatTheMethodDoesNotUse) {
  for (const int index : {0, 16})
    for (const auto& [method, place] : {std::pair{3, 6.0}, {4, 6.0}, {5, 0.0}, {6, 0.0}}) {
      HomingAxis axis{limits_and_home(2.0, 4.0), place};
      expect_error(axis, method + index, HomingError::LimitSwitch);
    }
}

TEST(HomingErrors, StopByTheRampOfHoming) {
  HomingAxis axis{limits()};
  axis.start(36);
  EXPECT_EQ(axis.run(), "000 100 101");
  EXPECT_NEAR(axis.load(), 8.0 + 20.0 * 20.0 / 2.0 / 200.0, 0.05);
}

TEST(HomingErrors, ComeWithTheSecondLimitSwitch) {
  for (const int index : {0, 16})
    for (int method = 7; method <= 14; ++method) {
      HomingAxis axis{limits()};
      expect_error(axis, method + index, HomingError::LimitSwitch);
      EXPECT_EQ(axis.reversals(), 1) << method;
      EXPECT_EQ(axis.load() < -4.0, method <= 10) << method;
    }
}

TEST(HomingErrors, ComeAtOnceOnALimitSwitchInTheWay) {
  for (const auto& [method, place] :
       {std::pair{33, -5.0}, {34, 9.0}, {36, 9.0}, {19, 9.0}, {20, 9.0}, {21, -5.0}, {22, -5.0}}) {
    HomingAxis axis{limits_and_home(2.0, 4.0), place};
    axis.start(method);
    EXPECT_EQ(axis.run(), "000 101") << method;
    EXPECT_EQ(axis.homing.error(), HomingError::LimitSwitch);
    EXPECT_EQ(axis.load(), place);
  }
}

TEST(HomingErrors, ComeWithALimitSwitchBeforeTheIndex) {
  TravelSwitches switches = limits_and_home(2.25, 4.25);
  switches.set(Signal::PositiveLimit, {.from = 2.75, .to = kEndless});
  HomingAxis axis{switches};
  axis.settings.zero_speed = axis.settings.switch_speed = kTurn / 4.0;
  expect_error(axis, 8, HomingError::LimitSwitch);
}

TEST(HomingErrors, ComeWithBothLimitSwitches) {
  for (int method = 1; method <= 14; ++method) {
    TravelSwitches broken;
    broken.set(Signal::NegativeLimit, {.from = -kEndless, .to = kEndless});
    broken.set(Signal::PositiveLimit, {.from = -kEndless, .to = kEndless});
    HomingAxis axis{broken};
    expect_error(axis, method, HomingError::LimitSwitch);
    EXPECT_EQ(axis.counts(), 0);
  }
}

TEST(HomingErrors, ComeWhenNothingComes) {
  for (const int method : {1, 2, 3, 8, 12, 17, 18, 19, 24, 30, 36}) {
    HomingAxis axis{{}};
    axis.settings.longest_search = 20.0;
    expect_error(axis, method, HomingError::NoEvent);
    EXPECT_NEAR(std::abs(axis.load()), 20.0 + 1.0, 0.05) << "and the ramp";
  }
}

TEST(HomingErrors, CountTheLongestSearchFromEachEvent) {
  TravelSwitches switches;
  switches.set(Signal::PositiveLimit, {.from = 15.0, .to = kEndless});
  switches.set(Signal::Home, {.from = -3.0, .to = -2.0});
  HomingAxis axis{switches};
  axis.settings.longest_search = 18.5;
  axis.start(23);
  EXPECT_EQ(axis.run(), "000 010 011") << "15 revolutions there, 17 back";
}

TEST(HomingErrors, AreSearchedForThe200RevolutionsOfTheLoad) {
  HomingAxis axis{{}, 0.0, 5.0};
  axis.settings.switch_speed = 500.0 * kTurn;
  expect_error(axis, 24, HomingError::NoEvent);
  EXPECT_GT(axis.load(), 200.0);
}

TEST(HomingErrors, ComeWithAFault) {
  HomingAxis axis{limits_and_home(2.0, 4.0)};
  axis.start(24);
  axis.cycles(50);
  axis.homing.leave(HomingExit::Fault);
  EXPECT_EQ(axis.bits(true), "100");
  EXPECT_EQ(axis.bits(false), "101");
  EXPECT_EQ(axis.homing.error(), HomingError::Fault);
  axis.homing.enter({.position = axis.demand().position});
  EXPECT_EQ(axis.bits(), "101") << "until the next start";
}

TEST(HomingErrors, AreNoneWhenAFaultComesAtRest) {
  HomingAxis axis{limits_and_home(2.0, 4.0)};
  axis.homing.leave(HomingExit::Fault);
  EXPECT_EQ(axis.bits(), "001");
}

TEST(HomingErrors, EndWithANewStart) {
  HomingAxis axis{limits_and_home(2.0, 4.0)};
  axis.start(0);
  EXPECT_EQ(axis.run(), "000 101");
  axis.start(24);
  EXPECT_EQ(axis.bits(), "000");
  EXPECT_EQ(axis.homing.error(), HomingError::None);
  EXPECT_EQ(axis.run(), "000 010 011");
}

TEST(HomingErrors, StayWhenBit4Falls) {
  HomingAxis axis{limits()};
  axis.start(36);
  while (axis.bits() == "000") axis.cycle();
  ASSERT_EQ(axis.bits(), "100");
  axis.write(kEnabled);
  EXPECT_EQ(axis.run(), "100 101");
}

TEST(HomingErrors, AreGoneWithTheMode) {
  HomingAxis axis{limits()};
  axis.start(0);
  EXPECT_EQ(axis.run(), "000 101");
  axis.homing.leave(HomingExit::OtherMode);
  axis.homing.enter(axis.demand());
  EXPECT_EQ(axis.bits(), "001");
}

}  // namespace
}  // namespace cia402
