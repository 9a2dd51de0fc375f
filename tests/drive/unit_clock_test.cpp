#include "drive/clock/unit_clock.hpp"

#include <gtest/gtest.h>

#include "tests/drive/clocked_unit.hpp"

namespace drive {
namespace {

TEST(UnitClock, CountsTheOperatingTimeInDaysAndMilliseconds) {
  ClockedUnit unit;
  unit.unit.set_time(3 * kMillisecondsOfADay + 1234);

  EXPECT_EQ(unit.shown(2114, 0), 1234.0);
  EXPECT_EQ(unit.shown(2114, 1), 3.0);
}

TEST(UnitClock, HasNoUtcBeforeItIsWanted) {
  TestUnit unit;
  unit.unit.set_time(5000);

  EXPECT_EQ(unit.write(kUnit, 3103, 2.0), std::nullopt);
  EXPECT_EQ(unit.write(kUnit, 3101, kDays, 1), std::nullopt);
  EXPECT_EQ(unit.write(kUnit, 3101, kNoon, 0), std::nullopt);

  EXPECT_EQ(value(unit.unit, kUnit, 3102, 0), 0.0);
  EXPECT_EQ(value(unit.unit, kUnit, 3102, 1), 0.0);
  EXPECT_FALSE(unit.unit.control_unit().clock().is_synchronised());
}

TEST(UnitClock, BeginsAtZeroWithEveryWriteOfTheMode) {
  ClockedUnit unit;
  unit.passes(1500);
  EXPECT_EQ(unit.milliseconds(), 1500.0);
  unit.tell(kNoon);
  EXPECT_TRUE(unit.is_synchronised());

  unit.put(3100, 1.0);

  EXPECT_EQ(unit.milliseconds(), 0.0);
  EXPECT_EQ(unit.days(), 0.0);
  EXPECT_FALSE(unit.is_synchronised());
  unit.put(3100, 0.0);
  unit.passes(1000);
  EXPECT_EQ(unit.milliseconds(), 0.0);
}

TEST(UnitClock, IsSetByTheMillisecondsOfTheDay) {
  ClockedUnit unit;
  unit.put(3101, kDays, 1);
  EXPECT_EQ(unit.days(), 0.0) << "the days alone set nothing";

  unit.put(3101, kNoon, 0);
  unit.passes(250);

  EXPECT_EQ(unit.days(), kDays);
  EXPECT_EQ(unit.milliseconds(), kNoon + 250.0);
  EXPECT_EQ(unit.shown(3101, 0), kNoon);
  EXPECT_TRUE(unit.is_synchronised());
}

TEST(UnitClock, GoesOnOverMidnight) {
  ClockedUnit unit;
  unit.tell(86'399'999.0);

  unit.passes(1);

  EXPECT_EQ(unit.milliseconds(), 0.0);
  EXPECT_EQ(unit.days(), kDays + 1.0);
}

TEST(UnitClock, TakesTheEndsOfItsRangesAndRefusesWhatIsBeyond) {
  ClockedUnit unit;
  unit.tell(86'399'999.0, 65535.0);
  EXPECT_EQ(unit.days(), 65535.0);

  EXPECT_EQ(unit.write(kUnit, 3101, 86'400'000.0, 0), Refusal::AboveMaximum);
  EXPECT_EQ(unit.write(kUnit, 3101, 65536.0, 1), Refusal::AboveMaximum);
  EXPECT_EQ(unit.write(kUnit, 3109, 1001.0), Refusal::AboveMaximum);
  for (const double method : {1.0, 3.0}) EXPECT_EQ(unit.write(kUnit, 3103, method), Refusal::IllegalValue);
  EXPECT_EQ(unit.write(kUnit, 3103, 5.0), Refusal::AboveMaximum);
  EXPECT_EQ(unit.write(kUnit, 3103, -1.0), Refusal::BelowMinimum);
  EXPECT_EQ(unit.shown(3103), 2.0);
}

TEST(UnitClock, ShowsTheDriftBetweenTwoCorrections) {
  ClockedUnit unit;
  unit.tell(kNoon);
  EXPECT_EQ(unit.shown(3108, 0), 0.0) << "the first time is no correction";
  unit.passes(1000);

  unit.tell(kNoon + 1030.0);
  EXPECT_EQ(unit.shown(3108, 0), 30.0);
  unit.passes(1000);
  unit.tell(kNoon + 2018.0);

  EXPECT_EQ(unit.shown(3108, 0), -12.0);
  EXPECT_EQ(unit.shown(3108, 1), 0.0);
  EXPECT_EQ(unit.milliseconds(), kNoon + 2018.0);
  EXPECT_FALSE(unit.is_violated());
}

TEST(UnitClock, RaisesAnAlarmBeyondTheToleranceUntilACorrectionWithin) {
  ClockedUnit unit;
  unit.tell(kNoon);
  EXPECT_FALSE(unit.is_violated());
  unit.tell(kNoon + 100.0);
  EXPECT_FALSE(unit.is_violated()) << "p3109 itself is allowed";

  unit.tell(kNoon - 1.0);
  EXPECT_TRUE(unit.is_violated());
  EXPECT_EQ(unit.shown(3107, 0), kNoon + 100.0);
  EXPECT_EQ(unit.shown(3107, 1), kDays);
  EXPECT_EQ(unit.shown(3107, 2), kNoon - 1.0);
  EXPECT_EQ(unit.shown(3107, 3), kDays);
  EXPECT_EQ(unit.shown(3108, 0), -101.0);
  EXPECT_EQ(unit.shown(3108, 1), -101.0);
  EXPECT_EQ(unit.milliseconds(), kNoon - 1.0) << "it is a correction all the same";

  unit.tell(kNoon + 4.0);
  EXPECT_FALSE(unit.is_violated());
  EXPECT_EQ(unit.shown(3108, 0), 5.0);
  EXPECT_EQ(unit.shown(3108, 1), -101.0);
}

TEST(UnitClock, EndsTheAlarmWithTheMode) {
  for (const double mode : {0.0, 1.0}) {
    ClockedUnit unit;
    unit.tell(kNoon);
    unit.tell(kNoon, 1.0);
    ASSERT_TRUE(unit.is_violated());
    EXPECT_EQ(unit.shown(3108, 1), -2147483648.0) << "further than it can show";

    unit.put(3100, mode);

    EXPECT_FALSE(unit.is_violated());
    EXPECT_EQ(unit.shown(3108, 1), 0.0);
  }
}

TEST(UnitClock, SaysWithASnapWhenThePingWas) {
  ClockedUnit unit{UnitClock::Method::PingSnap};
  unit.ping();
  unit.passes(300);

  unit.tell(kNoon);

  EXPECT_EQ(unit.milliseconds(), kNoon + 300.0);
  EXPECT_EQ(unit.days(), kDays);
  EXPECT_TRUE(unit.is_synchronised());
}

TEST(UnitClock, DropsASnapWithoutPingAndOneThatIsTooLate) {
  ClockedUnit unit{UnitClock::Method::PingSnap};
  unit.tell(kNoon);
  EXPECT_FALSE(unit.is_synchronised());
  unit.ping();
  unit.passes(5001);
  unit.tell(kNoon);
  EXPECT_FALSE(unit.is_synchronised());
  EXPECT_EQ(unit.milliseconds(), 5001.0);

  unit.ping();
  unit.passes(5000);
  unit.tell(kNoon);

  EXPECT_EQ(unit.milliseconds(), kNoon + 5000.0);
}

TEST(UnitClock, TakesOneSnapAPing) {
  ClockedUnit unit{UnitClock::Method::PingSnap};
  unit.ping();
  unit.tell(kNoon);
  unit.passes(100);

  unit.tell(kNoon + 40'000.0);

  EXPECT_EQ(unit.milliseconds(), kNoon + 100.0);
  unit.cycles_with_ping(true);
  unit.tell(kNoon);
  EXPECT_EQ(unit.milliseconds(), kNoon + 100.0) << "a level that stays is no edge";
}

TEST(UnitClock, CountsFromTheLatestPing) {
  ClockedUnit unit{UnitClock::Method::PingSnap};
  unit.ping();
  unit.passes(4000);
  unit.ping();
  unit.passes(4000);

  unit.tell(kNoon);

  EXPECT_EQ(unit.milliseconds(), kNoon + 4000.0);
}

TEST(UnitClock, ForgetsThePingWithAnotherMethodOrMode) {
  for (const std::uint16_t parameter : std::initializer_list<std::uint16_t>{3100, 3103}) {
    ClockedUnit unit{UnitClock::Method::PingSnap};
    unit.ping();

    unit.put(parameter, unit.shown(parameter));
    unit.tell(kNoon);

    EXPECT_FALSE(unit.is_synchronised()) << "p" << parameter;
  }
}

TEST(UnitClock, TakesATimeOverTheBusForItsMethodsOnly) {
  ClockedUnit unit{UnitClock::Method::Host};
  unit.ping();
  unit.tell(kNoon);

  EXPECT_FALSE(unit.is_synchronised());
}

TEST(UnitClock, IsLeftOutOfASaveButForItsSettings) {
  ClockedUnit unit;
  unit.tell(kNoon);
  EXPECT_FALSE(unit.unit.object(kUnit)->load(3101, 0, 5.0)) << "a time of yesterday is none";
  EXPECT_TRUE(unit.unit.object(kUnit)->load(3100, 0, 1.0));

  unit.unit.restore_parameters();

  EXPECT_EQ(unit.shown(3100), 0.0);
  EXPECT_EQ(unit.shown(3103), 0.0);
  EXPECT_EQ(unit.shown(3109), 100.0);
}

}  // namespace
}  // namespace drive
