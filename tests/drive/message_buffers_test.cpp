#include "drive/messages/message_buffers.hpp"

#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"

namespace drive {
namespace {

double value(const DriveObject& object, std::uint16_t number, std::size_t index = 0) {
  return object.read(number, index).value();
}

TEST(FaultBuffer, ShiftsACaseOfEightWithEveryAcknowledgement) {
  Axis axis{AxisConfiguration{}};
  for (int fault_case = 0; fault_case < 9; ++fault_case) {
    axis.set_time(static_cast<Uptime>(1000 * fault_case));
    ASSERT_TRUE(axis.raise(7900, static_cast<std::uint32_t>(fault_case)));
    ASSERT_TRUE(axis.raise(7860));
    ASSERT_TRUE(axis.acknowledge());
  }

  EXPECT_EQ(value(axis, 945, 0), 0.0);
  for (std::size_t past = 1; past < 8; ++past) {
    EXPECT_EQ(value(axis, 945, 8 * past), 7900.0);
    EXPECT_EQ(value(axis, 949, 8 * past), static_cast<double>(9 - past));
    EXPECT_EQ(value(axis, 948, 8 * past), 1000.0 * static_cast<double>(9 - past));
    EXPECT_EQ(value(axis, 945, 8 * past + 1), 7860.0);
    EXPECT_EQ(value(axis, 945, 8 * past + 2), 0.0);
  }
  EXPECT_EQ(value(axis, 952), 9.0);
}

TEST(FaultBuffer, KeepsWhatWasNotAcknowledgedInTheCurrentCase) {
  Axis axis{AxisConfiguration{}};
  ASSERT_TRUE(axis.raise(7860));
  ASSERT_TRUE(axis.raise(30022));  // power on

  EXPECT_FALSE(axis.acknowledge());

  EXPECT_EQ(value(axis, 945, 0), 30022.0);
  EXPECT_EQ(value(axis, 945, 1), 0.0);
  EXPECT_EQ(value(axis, 945, 8), 7860.0);
  EXPECT_EQ(value(axis, 952), 2.0);
}

TEST(FaultBuffer, IsClearedByZeroExceptForWhatIsActive) {
  Axis axis{AxisConfiguration{}};
  ASSERT_TRUE(axis.raise(7860));
  ASSERT_TRUE(axis.acknowledge());
  ASSERT_TRUE(axis.raise(7900));
  const double changes = value(axis, 944);

  EXPECT_EQ(axis.write(952, 1).error().reason, Refusal::OnlyZero);
  ASSERT_TRUE(axis.write(952, 0));

  EXPECT_EQ(value(axis, 945, 0), 7900.0);
  EXPECT_EQ(value(axis, 945, 8), 0.0);
  EXPECT_EQ(value(axis, 952), 0.0);
  EXPECT_EQ(value(axis, 944), changes + 1.0);
}

TEST(FaultBuffer, SurvivesPowerOff) {
  Axis axis{AxisConfiguration{}};
  ASSERT_TRUE(axis.raise(7860));

  axis.power_off();

  EXPECT_EQ(value(axis, 945, 0), 0.0);
  EXPECT_EQ(value(axis, 945, 8), 7860.0);
}

TEST(AlarmBuffer, KeepsEightInOrderAndMovesWhatIsGoneToTheHistory) {
  AlarmBuffer buffer;
  for (std::uint16_t n = 1; n <= 8; ++n) buffer.enter(n, 0, {n});
  buffer.leave(2, {20});
  buffer.leave(5, {50});
  EXPECT_EQ(buffer.at(1).number, 2);
  EXPECT_EQ(buffer.at(1).removed.uptime, 20u);

  buffer.enter(9, 0, {60});

  EXPECT_EQ(buffer.at(0).number, 1);
  EXPECT_EQ(buffer.at(1).number, 3);
  EXPECT_EQ(buffer.at(6).number, 9);
  EXPECT_EQ(buffer.at(7).number, 0);
  EXPECT_EQ(buffer.at(8).number, 5);
  EXPECT_EQ(buffer.at(9).number, 2);
  EXPECT_EQ(buffer.at(9).removed.uptime, 20u);
}

TEST(AlarmBuffer, LosesTheOldestOfTheHistory) {
  AlarmBuffer buffer;
  for (std::uint16_t n = 1; n <= 100; ++n) {
    buffer.enter(n, 0, {n});
    buffer.leave(n, {n});
  }

  EXPECT_EQ(buffer.at(3).number, 100);
  EXPECT_EQ(buffer.at(8).number, 96);
  EXPECT_EQ(buffer.at(63).number, 41);
}

TEST(AlarmBuffer, IsClearedByZeroExceptForWhatIsActive) {
  Axis axis{AxisConfiguration{}};
  ASSERT_TRUE(axis.raise(7910));
  ASSERT_TRUE(axis.raise(7012));
  axis.withdraw(7910);

  ASSERT_TRUE(axis.write(2111, 0));

  EXPECT_EQ(value(axis, 2122, 0), 7012.0);
  EXPECT_EQ(value(axis, 2122, 1), 0.0);
  EXPECT_EQ(value(axis, 2111), 0.0);
}

TEST(MessageSettings, ChangeWhatAFaultDoesToATurningMotor) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(2100, 4, 7900));
  ASSERT_TRUE(drive.axis.write(2101, 4, 1));  // OFF1 instead of OFF2
  ASSERT_TRUE(drive.axis.write(2100, 5, 8701));
  ASSERT_TRUE(drive.axis.write(2101, 5, 0));  // F08701 offers nothing
  EXPECT_EQ(drive.axis.write(2101, 6, 4).error().reason, Refusal::IllegalValue);

  ASSERT_TRUE(drive.axis.raise(7900));
  drive.run(TestAxis::kCycle);
  EXPECT_EQ(drive.state(), State::FaultReactionActive);
  EXPECT_NEAR(drive.rpm(), 1000.0, 10.0);
  ASSERT_TRUE(drive.axis.raise(8701));
  drive.run(0.02);
  EXPECT_LT(drive.rpm(), 900.0);
}

TEST(MessageSettings, MakeAFaultAnAlarmThatDoesNotStopTheMotor) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(2118, 0, 7860));
  ASSERT_TRUE(drive.axis.write(2119, 0, 2));

  ASSERT_TRUE(drive.axis.raise(7860));
  drive.run(0.1);

  EXPECT_EQ(drive.state(), State::OperationEnabled);
  EXPECT_EQ(drive.status() & 0x0088, 0x0080);
  drive.axis.withdraw(7860);
  EXPECT_EQ(drive.status() & 0x0088, 0x0000);
}

TEST(Acknowledgement, HasAParameterOfItsOwnForEachDriveObject) {
  Axis axis{AxisConfiguration{}};
  ASSERT_TRUE(axis.raise(7860));

  ASSERT_TRUE(axis.write(3981, 0));
  EXPECT_EQ(axis.messages().faults().size(), 1u);
  ASSERT_TRUE(axis.write(3981, 1));
  EXPECT_EQ(axis.messages().faults().size(), 0u);
  EXPECT_EQ(value(axis, 3981), 0.0);
}

}  // namespace
}  // namespace drive
