#include "drive/clock/unit_clock.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "drive/images/retained_image.hpp"
#include "tests/drive/image_fixture.hpp"
#include "tests/drive/wired_unit.hpp"

namespace drive {
namespace {

constexpr double kDays = 20779.0;       // 22 November 2026
constexpr double kNoon = 43'200'000.0;  // ms
constexpr std::uint16_t kViolated = 1099;

/// A unit with UTC that is told the time by the test.
struct ClockedUnit : WiredUnit {
  explicit ClockedUnit(UnitClock::Method method = UnitClock::Method::Simple) {
    passes(10);
    put(3100, 1.0);
    put(3103, static_cast<double>(method));
  }

  void passes(Uptime milliseconds) { unit.set_time(unit.runtime() + milliseconds); }
  void put(std::uint16_t number, double value, std::size_t index = 0) {
    ASSERT_EQ(write(kUnit, number, value, index), std::nullopt) << "p" << number;
  }
  /// Days, then milliseconds of the day.
  void tell(double milliseconds, double days = kDays) {
    put(3101, days, 1);
    put(3101, milliseconds, 0);
  }
  /// The level at p3104 for a cycle.
  void cycles_with_ping(bool level) {
    set(kUnit, 3104, level);
    unit.cycle(awake, 0.004);
  }
  /// A rising edge there.
  void ping() {
    cycles_with_ping(false);
    cycles_with_ping(true);
  }
  double milliseconds() const { return value(unit, kUnit, 3102, 0); }
  double days() const { return value(unit, kUnit, 3102, 1); }
  double shown(std::uint16_t number, std::size_t index = 0) const { return value(unit, kUnit, number, index); }
  bool is_violated() const {
    const auto alarms = unit.object(kUnit)->messages().alarms();
    return std::ranges::find(alarms, kViolated, [](const FaultEntry& e) { return e.row->number; }) != alarms.end();
  }
  bool is_synchronised() const { return unit.control_unit().clock().is_synchronised(); }
};

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

/// What r0948 with r2130, or r2109 with r2136, shows at @p index.
std::pair<double, double> time_of(const DriveUnit& unit, std::uint16_t milliseconds, std::uint16_t days,
                                  std::size_t index) {
  return {value(unit, kX, milliseconds, index), value(unit, kX, days, index)};
}
using Time = std::pair<double, double>;

TEST(UnitClock, StampsMessagesFromThenOn) {
  ClockedUnit unit;
  unit.put(3100, 0.0);
  unit.unit.set_time(2 * kMillisecondsOfADay + 500);
  ASSERT_TRUE(unit.unit.raise(kX, 7860));
  ASSERT_TRUE(unit.unit.raise(kX, 7850));
  unit.put(3100, 1.0);
  unit.tell(kNoon);
  unit.passes(20);
  unit.unit.acknowledge();
  unit.unit.withdraw(kX, 7850);
  ASSERT_TRUE(unit.unit.raise(kX, 7861));
  ASSERT_TRUE(unit.unit.raise(kX, 7850));

  EXPECT_EQ(time_of(unit.unit, 948, 2130, 8), (Time{500.0, 2.0})) << "that was before";
  EXPECT_EQ(time_of(unit.unit, 2109, 2136, 8), (Time{kNoon + 20.0, kDays}));
  EXPECT_EQ(time_of(unit.unit, 948, 2130, 0), (Time{kNoon + 20.0, kDays}));
  EXPECT_EQ(time_of(unit.unit, 2109, 2136, 0), (Time{0.0, 0.0}));
  EXPECT_EQ(time_of(unit.unit, 2123, 2145, 0), (Time{500.0, 2.0}));
  EXPECT_EQ(time_of(unit.unit, 2125, 2146, 0), (Time{kNoon + 20.0, kDays}));
  EXPECT_EQ(time_of(unit.unit, 2123, 2145, 1), (Time{kNoon + 20.0, kDays}));

  unit.put(3100, 0.0);
  ASSERT_TRUE(unit.unit.raise(kX, 7862));
  EXPECT_EQ(time_of(unit.unit, 948, 2130, 0), (Time{kNoon + 20.0, kDays})) << "what has a time keeps it";
  EXPECT_EQ(time_of(unit.unit, 948, 2130, 1), (Time{520.0, 2.0}));
}

std::vector<std::byte> kept_by(const DriveUnit& unit) {
  std::vector<std::byte> buffer(retained_image::size(unit));
  EXPECT_TRUE(retained_image::save(unit, buffer));
  return buffer;
}

TEST(UnitClock, LeavesItsStampsThroughAPowerCut) {
  ClockedUnit unit;
  ASSERT_TRUE(unit.unit.raise(kX, 7860));
  unit.tell(kNoon);
  unit.unit.acknowledge();
  ASSERT_TRUE(unit.unit.raise(kX, 7861));
  unit.passes(1000);

  DriveUnit next{two_axes()};
  ASSERT_TRUE(next.object(kUnit)->load(3100, 0, 1.0));
  ASSERT_TRUE(retained_image::load(next, kept_by(unit.unit)));

  EXPECT_EQ(time_of(next, 948, 2130, 8), (Time{kNoon, kDays}));
  EXPECT_EQ(time_of(next, 2109, 2136, 8), (Time{kNoon + 1000.0, kDays})) << "the power went";
  EXPECT_EQ(time_of(next, 948, 2130, 16), (Time{0.0, 0.0})) << "UTC had just begun";
  EXPECT_EQ(time_of(next, 2109, 2136, 16), (Time{kNoon, kDays}));
  EXPECT_EQ(value(next, kUnit, 3102, 0), 0.0) << "the clock itself begins anew";
  EXPECT_EQ(value(next, kUnit, 2114, 0), 1010.0);
}

/// An image as earlier releases wrote it: without times in UTC.
std::vector<std::byte> without_utc(std::vector<std::byte> image, std::size_t objects) {
  constexpr std::size_t kContent = 16 + 8 + 2, kHead = 4, kSectionHead = 4, kUtc = 8 + 64 * 16;
  constexpr std::size_t kFaults = 2 + 2 + 64 * 22, kEnergy = 16;
  std::size_t at = kContent;
  for (std::size_t i = 0; i < objects; ++i) {
    image[at + 2] = static_cast<std::byte>(std::to_integer<int>(image[at + 2]) - 1);
    const auto section = image.begin() + static_cast<std::ptrdiff_t>(at + kHead);
    image.erase(section, section + kSectionHead + kUtc);
    at += kHead + kSectionHead + kFaults + (i > 0 ? kSectionHead + kEnergy : 0);
  }
  EXPECT_EQ(at + 4, image.size());
  seal(image);
  return image;
}

TEST(UnitClock, TakesStampsWithoutUtcFromAnOlderImage) {
  TestUnit unit;
  unit.unit.set_time(700);
  ASSERT_TRUE(unit.unit.raise(kX, 7860));
  unit.unit.set_time(800);

  DriveUnit next{two_axes()};
  ASSERT_TRUE(retained_image::load(next, without_utc(kept_by(unit.unit), 3)));

  EXPECT_EQ(value(next, kX, 945, 8), 7860.0);
  EXPECT_EQ(time_of(next, 948, 2130, 8), (Time{700.0, 0.0}));
  EXPECT_EQ(time_of(next, 2109, 2136, 8), (Time{800.0, 0.0}));
}

}  // namespace
}  // namespace drive
