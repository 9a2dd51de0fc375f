#include "unit/cycle_clock.hpp"

#include <gtest/gtest.h>

namespace unit {
namespace {

using namespace std::chrono_literals;

static_assert(CycleClock::kMostAtOnce == 100ms);

constexpr TimePoint kStart{1h};

/// A clock of 4 ms that was begun at kStart and has run a cycle.
CycleClock running() {
  CycleClock clock;
  clock.begin(kStart);
  clock.wake(kStart);
  return clock;
}

TEST(CycleClock, RoundsItsPeriodToWholeControlPeriods) {
  EXPECT_EQ(CycleClock::period_of(4.0), 4ms);
  EXPECT_EQ(CycleClock::period_of(1.0), 1ms);
  EXPECT_EQ(CycleClock::period_of(1.05), 1ms);
  EXPECT_EQ(CycleClock::period_of(1.07), 1125us);
  EXPECT_EQ(CycleClock::period_of(16.0), 16ms);
}

TEST(CycleClock, RestsUntilItIsWoken) {
  CycleClock clock;
  clock.begin(kStart);

  EXPECT_TRUE(clock.is_resting());
  EXPECT_EQ(clock.next(), kNever);
  EXPECT_EQ(clock.take_first_due(kStart + 1h).run, 0);
  clock.wake(kStart);
  EXPECT_FALSE(clock.is_resting());
  EXPECT_EQ(clock.next(), kStart + 4ms);
}

TEST(CycleClock, KeepsItsGridThroughARest) {
  CycleClock clock = running();
  clock.rest();

  clock.wake(kStart + 10ms);

  EXPECT_EQ(clock.last(), kStart + 8ms);
  EXPECT_EQ(clock.next(), kStart + 12ms);
}

TEST(CycleClock, DoesNotRunACycleTwiceAfterAShortRest) {
  CycleClock clock = running();
  ASSERT_EQ(clock.take_due(kStart + 8ms).run, 2);
  clock.rest();

  clock.wake(kStart + 5ms);

  EXPECT_EQ(clock.next(), kStart + 12ms);
}

TEST(CycleClock, MakesUpForAtMost100MillisecondsAndCountsTheRest) {
  CycleClock clock = running();

  const CycleClock::Due due = clock.take_due(kStart + 1001ms);

  EXPECT_EQ(due.run, 25);
  EXPECT_EQ(due.skipped, 225);
  EXPECT_EQ(clock.next(), kStart + 1004ms);
}

TEST(CycleClock, GivesMissedCyclesOutOneByOne) {
  CycleClock clock = running();

  EXPECT_EQ(clock.take_first_due(kStart + 9ms).run, 1);
  EXPECT_EQ(clock.next(), kStart + 8ms);
  EXPECT_EQ(clock.take_first_due(kStart + 9ms).run, 1);
  EXPECT_EQ(clock.take_first_due(kStart + 9ms).run, 0);
  EXPECT_EQ(clock.next(), kStart + 12ms);
}

TEST(CycleClock, SkipsBeforeTheFirstMissedCycleWhatIsNotMadeUpFor) {
  CycleClock clock = running();

  const CycleClock::Due due = clock.take_first_due(kStart + 1000ms);

  EXPECT_EQ(due.run, 1);
  EXPECT_EQ(due.skipped, 225);
  EXPECT_EQ(clock.take_due(kStart + 1000ms).run, 24);
}

}  // namespace
}  // namespace unit
