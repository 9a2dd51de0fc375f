#include "tests/device/test_unit.hpp"

namespace device {
namespace {

using Numbers = std::vector<std::uint16_t>;

constexpr std::uint16_t kFaultBit = 0x0008;
constexpr std::uint32_t kInvalidValue = 0x06090030;

TEST(Fault, IsReportedByEmcyErrorRegisterErrorFieldAndStatusword) {
  TestUnit unit;
  unit.enable();

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));

  EXPECT_EQ(from("085#", unit.says("080#")), Lines{"085#001081B41E020000"});
  EXPECT_EQ(unit.upload(0x1001).number(), 0x81U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
  EXPECT_EQ(unit.upload(0x1003, 1).number(), 0x00021000U);
  EXPECT_EQ(unit.upload(0x1003, 2).number(), 1U);
  EXPECT_EQ(unit.upload(0x1003, 3).number(), 0x1EB41000U);
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, kFaultBit);
}

TEST(Fault, IsSentBeforeTheStatuswordThatShowsIt) {
  TestUnit unit;
  unit.start_operational();

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));

  const Lines lines = unit.passes(Device::kCycle);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "085#001081B41E020000");
  EXPECT_EQ(lines[1], "185#0816");
}

TEST(Fault, LeavesWithTheEdgeOfControlwordBit7) {
  TestUnit unit;
  unit.enable();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.passes(100ms);

  EXPECT_EQ(from("085#", unit.cycles_with("205#0000")), Lines{});
  EXPECT_EQ(from("085#", unit.cycles_with("205#8000")), Lines{"085#0000000000000000"});

  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
  EXPECT_EQ(unit.upload(0x1001).number(), 0U);
  for (std::uint8_t sub_index = 0; sub_index <= 0x52; ++sub_index)
    EXPECT_EQ(unit.upload(0x1003, sub_index).number(), 0U) << int{sub_index};
}

TEST(Fault, IsNotAcknowledgedByABitThatStaysSet) {
  TestUnit unit;
  unit.start_operational();
  unit.cycles_with("205#8000");
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));

  EXPECT_EQ(from("085#0000", unit.cycles_with("205#8000")), Lines{});

  EXPECT_EQ(unit.statusword() & kFaultBit, kFaultBit);
}

TEST(Fault, WithOff2LetsTheMotorCoast) {
  TestUnit unit{unit_with({{1120, 0.1}})};
  unit.turn_at(3000, 1s);

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
  unit.passes(100ms);

  EXPECT_EQ(unit.upload(0x6077).number(), 0U);
  EXPECT_GT(unit.velocity(), bus_speed(2800));
}

TEST(Fault, WithOff1BrakesInFaultReactionActiveFirst) {
  TestUnit unit{unit_with({{1082, 3000.0}, {1120, 0.1}, {1121, 0.5}})};
  unit.turn_at(3000, 1s);

  ASSERT_TRUE(unit.device.raise(1, 7220, 0, unit.now));
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x0F);
  unit.passes(246ms);
  EXPECT_NEAR(unit.velocity(), bus_speed(1500), bus_speed(100));

  EXPECT_TRUE(unit.reaches(0x4F, 0x08, 400ms));
}

TEST(ErrorField, AcknowledgesWithZeroOnly) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.passes(100ms);

  for (std::uint32_t value = 1; value <= 0xFF; ++value)
    ASSERT_EQ(unit.download(0x1003, 0, value, 1), kInvalidValue) << value;
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);

  EXPECT_EQ(unit.says("605#2F03100000000000"), (Lines{"085#0000000000000000", "585#6003100000000000"}));
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
  unit.passes(Device::kCycle);
  EXPECT_EQ(unit.statusword() & 0x4F, 0x40);
}

TEST(ErrorField, ShowsTheMessagesInTheOrderOfTheirArrival) {
  TestUnit unit;
  unit.start();

  for (const std::uint16_t number : Numbers{7860, 8751, 30002})
    ASSERT_TRUE(unit.device.raise(1, number, 0, unit.now));

  EXPECT_EQ(unit.passes(0ms), (Lines{"085#001081B41E020000", "085#1081912F22010000", "085#0010913275020000"}));
}

TEST(ErrorField, HasRoomForEightMessagesOfAnAxisAndCountsAll) {
  TestUnit unit;
  unit.start();

  for (const std::uint16_t number : Numbers{7011, 7860, 7861, 7862, 7900, 7901, 30001, 30002, 30003})
    ASSERT_TRUE(unit.device.raise(1, number, 0, unit.now));
  for (const std::uint16_t number : Numbers{8751, 8752}) ASSERT_TRUE(unit.device.raise(1, number, 0, unit.now));

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 10U);  // the ninth fault finds no room in the drive object
  EXPECT_EQ(unit.upload(0x1003, 1).number(), 0x00018120U);
  EXPECT_EQ(unit.upload(0x1003, 2).number(), 8U);
  EXPECT_EQ(unit.upload(0x1003, 3).number(), 7011U << 16 | 0x1000);
  EXPECT_EQ(unit.upload(0x1003, 0x0A).number(), 30002U << 16 | 0x1000);
  EXPECT_EQ(unit.upload(0x1003, 0x0B).number(), 0U);
}

TEST(Fault, ThatWaitsForPowerOnOutlivesAnAcknowledgement) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 30022, 0, unit.now));
  unit.passes(100ms);

  EXPECT_FALSE(unit.device.acknowledge(1, unit.now));
  EXPECT_EQ(unit.download(0x1003, 0, 0, 1), 0U);
  EXPECT_EQ(unit.passes(100ms), Lines{});

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
  EXPECT_EQ(unit.statusword() & kFaultBit, kFaultBit);
}

TEST(Fault, IsAcknowledgedFromOutsideTheBusToo) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.passes(100ms);

  EXPECT_TRUE(unit.device.acknowledge(1, unit.now));

  EXPECT_EQ(unit.passes(0ms), Lines{"085#0000000000000000"});
}

TEST(Fault, ThatIsActiveAlreadyIsNotReportedAgain) {
  TestUnit unit;
  unit.start();
  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));
  unit.passes(100ms);

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));

  EXPECT_EQ(unit.passes(100ms), Lines{});
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
}

TEST(Fault, IsKeptSilentByAnInvalidEmcyCobId) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1014, 0, 0x80000085, 4), 0U);

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));

  EXPECT_EQ(unit.passes(100ms), Lines{});
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
}

TEST(BlockedMotor, RaisesF07900AfterASecondAtTheTorqueLimit) {
  Configuration configuration = unit_with({{1120, 0.1}});
  configuration.axes.front().drive.load.coulomb_friction = 40.0;  // the motor has 35 N·m
  TestUnit unit{configuration};
  unit.enable();
  unit.says("305#0F000000800C");

  EXPECT_EQ(from("085#", unit.passes(990ms)), Lines{});
  EXPECT_EQ(from("085#", unit.passes(50ms)), Lines{"085#001081DC1E020000"});
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
  EXPECT_EQ(unit.velocity(), 0);
}

TEST(OverspeedOfTheMotor, RaisesF07901) {
  TestUnit unit;
  unit.enable();

  unit.device.set_load_torque(1, -40.0, unit.now);  // more than the motor can hold

  EXPECT_EQ(from("085#", unit.passes(2s)), Lines{"085#001081DD1E020000"});
  EXPECT_EQ(unit.statusword() & 0x4F, 0x08);
}

}  // namespace
}  // namespace device
