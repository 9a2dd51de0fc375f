#include "tests/device/test_unit.hpp"

namespace device {
namespace {

/// An operational unit at rest whose TPDO1 and RPDO1 have the transmission types @p transmit and @p receive.
void start_with_types(TestUnit& unit, std::uint32_t transmit, std::uint32_t receive) {
  unit.start();
  ASSERT_EQ(unit.download(0x1800, 2, transmit, 1), 0U);
  ASSERT_EQ(unit.download(0x1400, 2, receive, 1), 0U);
  unit.says("000#0105");
  unit.passes(8ms);
}

TEST(SynchronousTpdo, OfType1IsSentAtEverySyncOnly) {
  TestUnit unit;
  start_with_types(unit, 1, 0xFE);

  EXPECT_EQ(from("185#", unit.cycles_with("205#0600")), Lines{});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(unit.says("080#"), Lines{"185#3116"});
}

TEST(SynchronousTpdo, OfTypeNIsSentAtEveryNthSync) {
  TestUnit unit;
  start_with_types(unit, 3, 0xFE);

  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(unit.says("080#"), Lines{});
    EXPECT_EQ(unit.says("080#"), Lines{});
    EXPECT_EQ(unit.says("080#"), Lines{"185#4016"});
  }
}

TEST(SynchronousTpdo, OfType0IsSentAtASyncAfterAChange) {
  TestUnit unit;
  start_with_types(unit, 0, 0xFE);
  EXPECT_EQ(unit.says("080#"), Lines{"185#4016"});

  EXPECT_EQ(unit.says("080#"), Lines{});
  EXPECT_EQ(from("185#", unit.cycles_with("205#0600")), Lines{});
  EXPECT_EQ(unit.says("080#"), Lines{"185#3116"});
  EXPECT_EQ(unit.says("080#"), Lines{});
}

TEST(SynchronousTpdo, ShowsTheLastFinishedCycleWhateverHasComeSince) {
  TestUnit unit;
  start_with_types(unit, 1, 0xFE);

  EXPECT_EQ(unit.says("205#0600"), Lines{});
  EXPECT_EQ(unit.says("080#"), Lines{"185#4016"}) << "an RPDO";
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.says("080#"), Lines{"185#3116"});

  ASSERT_EQ(unit.download(0x6040, 0, 7, 2), 0U);
  EXPECT_EQ(unit.says("080#"), Lines{"185#3116"}) << "an SDO";
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.says("080#"), Lines{"185#3316"});

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  EXPECT_EQ(from("185#", unit.says("080#")), Lines{"185#3316"}) << "a fault";
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.says("080#"), Lines{"185#3816"});
}

TEST(SynchronousTpdo, IsNotSentOutsideOperational) {
  TestUnit unit;
  start_with_types(unit, 1, 0xFE);
  unit.says("000#8005");

  EXPECT_EQ(unit.says("080#"), Lines{});
}

TEST(SynchronousRpdo, ActsAfterTheNextSync) {
  for (const std::uint32_t type : {0x00U, 0x01U, 0xF0U}) {
    TestUnit unit;
    start_with_types(unit, 0xFE, type);

    unit.says("205#0600");
    EXPECT_EQ(unit.passes(100ms), Lines{}) << type;
    EXPECT_EQ(unit.cycles_with("080#"), at_rest(0x1631)) << type;
  }
}

TEST(SynchronousRpdo, ThatWaitedIsForgottenOutsideOperational) {
  TestUnit unit;
  start_with_types(unit, 0xFE, 1);
  unit.says("205#0600");

  unit.says("000#0205");
  unit.says("000#0105");
  unit.says("080#");
  unit.passes(100ms);

  EXPECT_EQ(unit.upload(0x6040).number(), 0U);
}

TEST(Sync, IsTheIdentifierOf1005h) {
  TestUnit unit;
  start_with_types(unit, 1, 0xFE);
  ASSERT_EQ(unit.download(0x1005, 0, 0x81, 4), 0U);

  EXPECT_EQ(unit.says("080#"), Lines{});
  EXPECT_EQ(unit.says("081#"), Lines{"185#4016"});
  EXPECT_EQ(unit.download(0x1005, 0, 0x40000080, 4), 0x06090030U);  // the unit produces no SYNC
}

TEST(EventTimer, SendsATpdoOnceAPeriodAlsoAtRest) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1800, 5, 100, 2), 0U);
  unit.passes(100ms);
  EXPECT_EQ(unit.says("000#0105"), at_rest(0x1640));

  EXPECT_EQ(unit.passes(500ms), Lines(5, "185#4016"));
  EXPECT_EQ(unit.device.next_deadline(), unit.now + 100ms);
}

TEST(EventTimer, IsRoundedUpToWholeCyclesAlsoAtRest) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1800, 5, 9, 2), 0U);
  unit.passes(101ms);
  unit.says("000#0105");
  EXPECT_EQ(unit.passes(3ms), at_rest(0x1640)) << "where the next cycle would end";

  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(unit.passes(11ms), Lines{});
    EXPECT_EQ(unit.passes(1ms), Lines{"185#4016"});
  }
}

TEST(EventTimer, CannotBeChangedInOperational) {
  TestUnit unit;
  unit.start_operational();
  unit.passes(100ms);

  EXPECT_EQ(unit.download(0x1800, 5, 50, 2), 0x08000022U);
  EXPECT_EQ(unit.passes(Device::kCycle), at_rest(0x16C0)) << "A08754";
  EXPECT_EQ(unit.passes(1s), Lines{});
}

TEST(InhibitTime, KeepsTheTpdosOfAnAcceleratingMotorApart) {
  TestUnit unit{unit_with({{1120, 10.0}})};
  unit.start();
  ASSERT_EQ(unit.download(0x1801, 1, 0x80000285, 4), 0U);
  ASSERT_EQ(unit.download(0x1801, 3, 1000, 2), 0U);  // 100 ms
  ASSERT_EQ(unit.download(0x1801, 1, 0x00000285, 4), 0U);
  for (const char* const frame : {"000#0105", "205#0600", "205#0700", "205#0F00"}) unit.cycles_with(frame);
  unit.says("305#0F000000800C");
  unit.passes(100ms);

  const Lines lines = unit.passes(1s);

  EXPECT_EQ(from("285#", lines).size(), 10U);
  EXPECT_EQ(from("485#", lines).size(), 250U);
}

}  // namespace
}  // namespace device
