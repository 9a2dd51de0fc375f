#include "cia402/modes/cyclic/set_point_clock.hpp"

#include <gtest/gtest.h>

#include "tests/cia402/cyclic/timeline.hpp"

namespace cia402 {
namespace {

using enum SetPointPhase;

TEST(InterpolationPeriod, IsValueTimesPowerOfTen) {
  EXPECT_EQ(interpolation_period(10, -3), 10ms);
  EXPECT_EQ(interpolation_period(50, -3), 50ms);
  EXPECT_EQ(interpolation_period(255, 0), 255s);
  EXPECT_EQ(interpolation_period(25, -4), 2500us);
  EXPECT_EQ(interpolation_period(1, -3), 1ms);
}

TEST(InterpolationPeriod, IsACycleAtLeast) {
  EXPECT_EQ(interpolation_period(255, -6), 1ms);
  EXPECT_EQ(interpolation_period(9, -4), 1ms);
  EXPECT_EQ(interpolation_period(11, -4), 1100us);
}

/// @p clock after @p by, as often as it changes its phase.
void advance(SetPointClock& clock, TimeNs by, bool is_supervised) {
  while (by > TimeNs{}) {
    const TimeNs step = std::min(by, clock.until_change());
    clock.advance(step, is_supervised);
    by -= step;
  }
}

TEST(SetPointClock, HoldsWithoutSupervisionForEver) {
  SetPointClock clock;
  advance(clock, 1s, false);
  EXPECT_EQ(clock.phase(), None);
  EXPECT_FALSE(clock.is_led());
  clock.take(10ms);
  EXPECT_EQ(clock.phase(), OnTime);
  advance(clock, 10ms - 1ns, false);
  EXPECT_EQ(clock.phase(), OnTime);
  advance(clock, 1ns, false);
  EXPECT_EQ(clock.phase(), Held);
  advance(clock, 100h, false);
  EXPECT_EQ(clock.phase(), Held);
  EXPECT_EQ(clock.missed(), 0U);
  EXPECT_TRUE(clock.is_led());
}

TEST(SetPointClock, MissesASetPointEveryPeriod) {
  SetPointClock clock;
  clock.take(10ms);
  advance(clock, 10ms, true);
  EXPECT_EQ(clock.phase(), Late);
  for (std::uint32_t missed = 1; missed < 20; ++missed) {
    advance(clock, 1ms - 1ns, true);
    EXPECT_EQ(clock.missed(), missed - 1);
    advance(clock, 1ns, true);
    EXPECT_EQ(clock.missed(), missed);
    EXPECT_EQ(clock.phase(), missed == 1 ? Late : Missing);
    advance(clock, 9ms, true);
  }
  clock.take(10ms);
  EXPECT_EQ(clock.missed(), 0U);
}

TEST(SetPointClock, WaitsHalfAShortPeriod) {
  SetPointClock clock;
  clock.take(1ms);
  advance(clock, 1500us - 1ns, true);
  EXPECT_EQ(clock.missed(), 0U);
  advance(clock, 1ns, true);
  EXPECT_EQ(clock.missed(), 1U);
  advance(clock, 2ms, true);
  EXPECT_EQ(clock.missed(), 3U);
}

TEST(SetPointClock, LosesWhatTheSettingsSay) {
  SetPointClock clock;
  clock.take(10ms);
  const auto lost = [&clock](std::uint32_t after) { return clock.is_lost({.missed_set_points = after}); };
  EXPECT_FALSE(lost(0));
  EXPECT_FALSE(lost(1));
  advance(clock, 11ms, true);
  EXPECT_TRUE(lost(1));
  EXPECT_FALSE(lost(2));
  advance(clock, 1h, true);
  EXPECT_TRUE(lost(1000));
  EXPECT_FALSE(lost(0));
}

TEST(SetPointClock, CountsNoMissesWhileNobodySupervises) {
  SetPointClock clock;
  clock.take(10ms);
  advance(clock, 11ms, true);
  EXPECT_EQ(clock.missed(), 1U);
  advance(clock, 20ms, false);
  EXPECT_EQ(clock.missed(), 1U);
  EXPECT_EQ(clock.phase(), Missing);
}

}  // namespace
}  // namespace cia402
