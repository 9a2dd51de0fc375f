#include "drive/messages/fault_memory.hpp"

#include <gtest/gtest.h>

namespace drive {
namespace {

const FaultRow& row(std::uint16_t number) {
  return *find_fault(number);
}

TEST(FaultTable, HasAllMessagesWithUniqueNumbersAndTheirTexts) {
  EXPECT_EQ(fault_rows().size(), 164u);
  EXPECT_EQ(fault_text(row(7900)), "F07900");
  EXPECT_EQ(fault_text(row(8751)), "A08751");
  EXPECT_EQ(fault_text(row(30005)), "F30005");
  EXPECT_EQ(row(8700).name, "CAN communication error");
  EXPECT_EQ(find_fault(1), nullptr);
  EXPECT_EQ(find_fault(65535), nullptr);
}

TEST(FaultMemory, KeepsFaultsAndAlarmsInTheOrderOfTheirAppearance) {
  FaultMemory memory;

  memory.enter(row(7901), 0, Cause::Gone);
  memory.enter(row(8751), 0, Cause::Present);
  memory.enter(row(7220), 5, Cause::Gone);

  ASSERT_EQ(memory.faults().size(), 2u);
  EXPECT_EQ(memory.faults()[0].row->number, 7901);
  EXPECT_EQ(memory.faults()[1].row->number, 7220);
  EXPECT_EQ(memory.faults()[1].value, 5u);
  ASSERT_EQ(memory.alarms().size(), 1u);
  EXPECT_EQ(memory.most_recent()->row->number, 7220);
  EXPECT_LT(memory.faults()[0].sequence, memory.alarms()[0].sequence);
  EXPECT_LT(memory.alarms()[0].sequence, memory.faults()[1].sequence);
}

TEST(FaultMemory, CountsAChangeForEveryMessageThatEntersOrLeavesAndForNothingElse) {
  FaultMemory memory;
  memory.enter(row(8751), 0, Cause::Present);
  EXPECT_EQ(memory.change_count(), 1u);
  memory.enter(row(8751), 0, Cause::Present);
  EXPECT_EQ(memory.change_count(), 1u);

  memory.withdraw(row(8751));
  EXPECT_EQ(memory.change_count(), 2u);
  memory.withdraw(row(8751));
  EXPECT_EQ(memory.change_count(), 2u);
  EXPECT_EQ(memory.most_recent(), nullptr);
}

TEST(FaultMemory, HoldsEightFaultsAndEightAlarms) {
  FaultMemory memory;

  for (const FaultRow& message : fault_rows()) memory.enter(message, 0, Cause::Gone);

  EXPECT_EQ(memory.faults().size(), 8u);
  EXPECT_EQ(memory.alarms().size(), 8u);
}

TEST(FaultMemory, AcknowledgesEachClassOnItsOwnCondition) {
  FaultMemory memory;
  memory.enter(row(7901), 0, Cause::Gone);     // immediately
  memory.enter(row(31100), 0, Cause::Gone);    // with the pulses off
  memory.enter(row(30022), 0, Cause::Gone);    // power on
  memory.enter(row(7011), 0, Cause::Present);  // the cause remains

  EXPECT_FALSE(memory.acknowledge(true));
  ASSERT_EQ(memory.faults().size(), 3u);
  EXPECT_FALSE(memory.acknowledge(false));
  ASSERT_EQ(memory.faults().size(), 2u);
  EXPECT_EQ(memory.faults()[0].row->number, 30022);
  memory.withdraw(row(7011));
  EXPECT_FALSE(memory.acknowledge(false));
  ASSERT_EQ(memory.faults().size(), 1u);
  memory.clear();
  EXPECT_TRUE(memory.acknowledge(false));
}

TEST(FaultMemory, RemembersAnAcknowledgementUntilACauseThatIsEndingIsGone) {
  FaultMemory memory;
  memory.enter(row(8700), 1, Cause::Ending);
  memory.enter(row(7860), 0, Cause::Present);

  EXPECT_FALSE(memory.acknowledge(false));
  EXPECT_EQ(memory.faults().size(), 2u);

  EXPECT_TRUE(memory.withdraw(row(8700)));
  EXPECT_FALSE(memory.withdraw(row(7860)));
  ASSERT_EQ(memory.faults().size(), 1u);
  EXPECT_EQ(memory.faults()[0].row->number, 7860);
  EXPECT_EQ(memory.fault(8).number, 8700) << "it has become a case of the buffer";
}

TEST(FaultMemory, ForgetsAnAcknowledgementWhenTheFaultComesAgain) {
  FaultMemory memory;
  memory.enter(row(8700), 1, Cause::Ending);
  memory.acknowledge(false);

  memory.enter(row(8700), 1, Cause::Ending);

  EXPECT_FALSE(memory.withdraw(row(8700)));
  EXPECT_TRUE(memory.acknowledge(false));
}

TEST(FaultMemory, AnAcknowledgementLeavesAlarmsAlone) {
  FaultMemory memory;
  memory.enter(row(8752), 0, Cause::Present);

  EXPECT_TRUE(memory.acknowledge(false));

  EXPECT_EQ(memory.alarms().size(), 1u);
}

TEST(FaultMemory, KeepsALatchedAlarmUntilTheAlarmsAreCleared) {
  FaultMemory memory;
  memory.enter(row(8752), 0, Cause::Present);
  memory.enter(row(8758), 1, Cause::Latched);

  EXPECT_TRUE(memory.acknowledge(false));
  EXPECT_EQ(memory.alarms().size(), 2u);
  const auto changes = memory.change_count();
  memory.clear_alarm_buffer();

  ASSERT_EQ(memory.alarms().size(), 1u);
  EXPECT_EQ(memory.alarms()[0].row->number, 8752);
  EXPECT_NE(memory.change_count(), changes);
  EXPECT_EQ(memory.alarm(0).number, 8752);
  EXPECT_EQ(memory.alarm(1).number, 0);
}

TEST(FaultMemory, ShowsTheErrorRegisterOfWhatIsActive) {
  FaultMemory memory;
  EXPECT_EQ(memory.error_register(), 0x00);

  memory.enter(row(7910), 0, Cause::Present);  // an alarm of the drive is not seen there
  EXPECT_EQ(memory.error_register(), 0x00);
  memory.enter(row(8752), 0, Cause::Present);
  EXPECT_EQ(memory.error_register(), 0x11);
  memory.enter(row(7901), 0, Cause::Gone);
  EXPECT_EQ(memory.error_register(), 0x91);
}

TEST(FaultMemory, GivesEachMessageItsCanopenErrorCode) {
  FaultMemory memory;
  memory.enter(row(8700), 1, Cause::Gone);
  EXPECT_EQ(memory.most_recent()->emcy_code(), 0x1001);
  memory.enter(row(8700), 2, Cause::Gone);
  EXPECT_EQ(memory.most_recent()->emcy_code(), 0x8130);
  memory.enter(row(8701), 1, Cause::Gone);
  EXPECT_EQ(memory.most_recent()->emcy_code(), 0x1001);
  memory.enter(row(8751), 0, Cause::Gone);
  EXPECT_EQ(memory.most_recent()->emcy_code(), 0x8110);
  memory.enter(row(30001), 0, Cause::Gone);
  EXPECT_EQ(memory.most_recent()->emcy_code(), 0x1000);
}

}  // namespace
}  // namespace drive
