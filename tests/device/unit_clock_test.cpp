#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

constexpr std::uint64_t kDays = 20779;       // 22 November 2026
constexpr std::uint64_t kNoon = 43'200'000;  // ms
constexpr std::uint16_t kModeObject = 0x2C1C, kTime = 0x2C1E, kMethod = 0x2C1F;
constexpr std::string_view kConfirmedMode = "585#601C2C0000000000";
constexpr std::string_view kGivesDays = "605#231D2C012B510000", kTakesDays = "585#601D2C0100000000";
constexpr std::string_view kGivesNoon = "605#231D2C00002E9302", kTakesNoon = "585#601D2C0000000000";

/// A unit whose window shows the control unit, with UTC.
struct ClockUnit : Window {
  explicit ClockUnit(unsigned method) : Window{1} {
    says("000#0105");
    EXPECT_EQ(write(3100, 1), 0U);
    EXPECT_EQ(write(3103, method), 0U);
    passes(1s);
    EXPECT_EQ(device.next_deadline(), canopen::kNever) << "the unit rests";
  }
  std::uint64_t milliseconds() { return upload(kTime, 0).number(); }
  std::uint64_t days() { return upload(kTime, 1).number(); }
  /// A snap of noon.
  void noon() { expect_dialogue({{kGivesDays, kTakesDays}, {kGivesNoon, kTakesNoon}}); }
};

TEST(UnitClock, IsSetInTheSimpleWay) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({{"605#2BB6410001000000", "585#60B6410000000000"},
                        {"605#2B1C2C0001000000", kConfirmedMode},
                        {"605#2B1F2C0002000000", "585#601F2C0000000000"},
                        {kGivesDays, kTakesDays},
                        {kGivesNoon, kTakesNoon},
                        {"605#401E2C0100000000", "585#431E2C012B510000"},
                        {"605#401E2C0000000000", "585#431E2C00002E9302"}});
}

TEST(UnitClock, CountsFromThePingThatAnRpdoBringsToAUnitAtRest) {
  ClockUnit unit{0};
  unit.expect_dialogue({{"605#23202C000B08BA22", "585#60202C0000000000"}});  // p3104 = r8890.11 of drive object 2
  unit.passes(1s);

  unit.says("205#0008");  // bit 11 of the controlword
  unit.passes(300ms);
  EXPECT_EQ(unit.device.next_deadline(), canopen::kNever) << "the unit rests again";
  unit.noon();

  const std::uint64_t late = 300 - (unit.milliseconds() - kNoon);
  EXPECT_LE(late, 4U) << "one process-data cycle";
  EXPECT_EQ(unit.days(), kDays);
}

TEST(UnitClock, CountsFromThePingThatASlowMasterWritesOverSdo) {
  ClockUnit unit{0};
  unit.expect_dialogue({{"605#23202C000B08BA22", "585#60202C0000000000"}});

  unit.download(0x6040, 0, 0x0800, 2);
  unit.passes(300ms);
  unit.noon();

  EXPECT_NEAR(static_cast<double>(unit.milliseconds()), static_cast<double>(kNoon + 300), 4.0);
}

TEST(UnitClock, CountsFromThePingOfATerminal) {
  ClockUnit unit{0};
  unit.expect_dialogue({{"605#23202C000304D202", "585#60202C0000000000"}});  // p3104 = r0722.3
  unit.device.set_input(3, true, unit.now);
  unit.passes(300ms);

  unit.noon();

  EXPECT_NEAR(static_cast<double>(unit.milliseconds()), static_cast<double>(kNoon + 300), 4.0);
}

TEST(UnitClock, LeavesTheClockAloneWithoutAPing) {
  ClockUnit unit{0};
  const std::uint64_t before = unit.milliseconds();

  unit.noon();

  EXPECT_EQ(unit.milliseconds(), before);
}

TEST(UnitClock, RefusesAnotherMethod) {
  ClockUnit unit{2};

  EXPECT_EQ(unit.download(kMethod, 0, 1, 2), 0x06090030U);
  EXPECT_EQ(unit.download(kMethod, 0, 5, 2), 0x06090031U);
  EXPECT_EQ(unit.download(0x2C1D, 0, 86'400'000, 4), 0x06090031U);
  EXPECT_EQ(unit.download(0x2C1E, 0, 1, 4), 0x06010002U);
  EXPECT_EQ(unit.upload(kMethod).number(), 2U);
}

TEST(UnitClock, ShowsAnAlarmOfACorrectionThatIsTooLarge) {
  ClockUnit unit{2};
  unit.noon();
  unit.passes(60s);
  EXPECT_EQ(unit.read(2132), 0U);

  unit.noon();
  EXPECT_EQ(unit.read(2132), 1099U);
  EXPECT_EQ(static_cast<std::int32_t>(unit.upload(0x2C24, 0).number()), -60'000);

  unit.passes(2ms);
  unit.noon();
  EXPECT_EQ(unit.read(2132), 0U);
  EXPECT_EQ(static_cast<std::int32_t>(unit.upload(0x2C24, 0).number()), -2);
}

TEST(UnitClock, StampsTheFaultsThatAMasterReads) {
  ClockUnit unit{2};
  unit.noon();
  unit.passes(1500ms);
  ASSERT_TRUE(unit.device.raise(1, 7860, 42, unit.now));
  unit.show(2);

  EXPECT_EQ(unit.read(945), 7860U);
  EXPECT_EQ(unit.read(948), kNoon + 1500);
  EXPECT_EQ(unit.read(2130), kDays);
  unit.passes(500ms);
  unit.device.acknowledge(1, unit.now);
  EXPECT_EQ(unit.upload(0x283D, 8).number(), kNoon + 2000);  // r2109
  EXPECT_EQ(unit.upload(0x2858, 8).number(), kDays);         // r2136

  const auto kept = unit.device.retained(unit.now);
  TestUnit next;
  ASSERT_TRUE(next.device.load_retained(kept));
  next.start();
  ASSERT_EQ(next.download(0x41B6, 0, 2, 2), 0U);
  EXPECT_EQ(next.upload(0x23B4, 8).number(), kNoon + 1500);  // r0948
  EXPECT_EQ(next.upload(0x2852, 8).number(), kDays);         // r2130
}

TEST(UnitClock, GoesOnThroughAResetOfTheCommunicationOnly) {
  ClockUnit unit{2};
  unit.noon();

  unit.says("000#8205");
  unit.passes(1s);
  EXPECT_NEAR(static_cast<double>(unit.milliseconds()), static_cast<double>(kNoon + 1000), 1.0);

  unit.says("000#8105");
  unit.passes(1s);
  EXPECT_EQ(unit.device.unit().object(1)->read(3100).value(), 0.0) << "it was not saved";
}

TEST(UnitClock, BeginsAnewAfterAPowerCut) {
  ClockUnit unit{2};
  unit.noon();
  ASSERT_EQ(unit.download(kStore, 1, kSave, 4), 0U);

  NextLife next{unit};
  next.unit.passes(700ms);

  ASSERT_EQ(next.unit.download(0x41B6, 0, 1, 2), 0U);
  EXPECT_EQ(next.unit.upload(kModeObject).number(), 1U);
  EXPECT_EQ(next.unit.upload(kTime, 0).number(), 700U);
  EXPECT_EQ(next.unit.upload(kTime, 1).number(), 0U);
}

TEST(UnitClock, TakesTheTimeOfTheHostAndAsksItNowAndThen) {
  ClockUnit unit{0};
  unit.listener.host = kDays * 86'400'000 + kNoon;
  ASSERT_EQ(unit.write(3103, 4), 0U);
  EXPECT_EQ(unit.milliseconds(), kNoon);
  EXPECT_EQ(unit.days(), kDays);
  EXPECT_TRUE(unit.device.unit().control_unit().clock().is_synchronised());

  const int asked = unit.listener.host_questions;
  unit.passes(63s);
  EXPECT_EQ(unit.milliseconds(), kNoon + 63'000) << "the clock of the unit itself";
  EXPECT_EQ(unit.listener.host_questions, asked);
  *unit.listener.host += 64'000 + 500;
  unit.passes(1s);

  EXPECT_EQ(unit.milliseconds(), kNoon + 64'500);
  EXPECT_EQ(unit.read(2132), 1099U);
}

TEST(UnitClock, GoesOnWhileTheHostDoesNotKnow) {
  ClockUnit unit{4};
  const std::uint64_t before = unit.milliseconds();
  unit.passes(100s);

  EXPECT_EQ(unit.milliseconds(), before + 100'000);
  EXPECT_EQ(unit.read(2132), 0U);
  EXPECT_FALSE(unit.device.unit().control_unit().clock().is_synchronised());
}

}  // namespace
}  // namespace device
