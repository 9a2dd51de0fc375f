// Faults and alarms as a master sees them: reaction, statusword, acknowledgement.
#include <algorithm>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/test_axis.hpp"
#include "tests/fakes/fault_row_names.hpp"

namespace drive {
namespace {

constexpr std::uint16_t kFaultMask = 0x004F;

class EveryMessage : public testing::TestWithParam<FaultRow> {};

TEST_P(EveryMessage, ReactsAsTheTableSaysInMotion) {
  const FaultRow& row = GetParam();
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1135, 10.0));

  const auto raised = drive.axis.raise(row.number);
  drive.run(TestAxis::kCycle);

  if (row.scope == Scope::ControlUnit) {
    EXPECT_EQ(raised.error(), FaultError::NotOnThisAxis);
    EXPECT_EQ(drive.status(), 0x0637);
    return;
  }
  ASSERT_TRUE(raised);
  EXPECT_NEAR(drive.rpm(), 1000.0, 10.0);
  if (row.kind == Kind::Alarm) {
    EXPECT_EQ(drive.status(), 0x06B7);
    drive.axis.withdraw(row.number);
    EXPECT_EQ(drive.status(), 0x0637);
    return;
  }
  const bool braking = row.reaction == Reaction::Off1 || row.reaction == Reaction::Off3;
  const bool none = row.reaction == Reaction::None;
  EXPECT_EQ(drive.axis.actual().pulses_enabled, braking || none);
  EXPECT_EQ(drive.status() & kFaultMask, none || braking ? 0x000F : 0x0008);
  EXPECT_EQ(drive.state(), none ? State::OperationEnabled : braking ? State::FaultReactionActive : State::Fault);
}

/// The faults that an axis can have.
std::vector<FaultRow> faults_of_an_axis() {
  std::vector<FaultRow> rows;
  std::copy_if(fault_rows().begin(), fault_rows().end(), std::back_inserter(rows),
               [](const FaultRow& row) { return row.kind == Kind::Fault && row.scope != Scope::ControlUnit; });
  return rows;
}

class EveryFault : public testing::TestWithParam<FaultRow> {};

TEST_P(EveryFault, IsAcknowledgedAtStandstillAsItsClassSays) {
  const FaultRow& row = GetParam();
  TestAxis drive;
  drive.send(0x0006);
  drive.send(0x0006);

  ASSERT_TRUE(drive.axis.raise(row.number));
  const bool none = row.reaction == Reaction::None;
  EXPECT_EQ(drive.send(0x0006), none ? 0x1639 : 0x1638);
  drive.send(0x0080);

  const bool stays = row.acknowledge == Acknowledge::PowerOn;
  EXPECT_EQ(drive.axis.messages().faults().size(), stays ? 1u : 0u);
  EXPECT_EQ(drive.status(), stays ? 0x1608 : 0x1640);
}

INSTANTIATE_TEST_SUITE_P(Table, EveryMessage, testing::ValuesIn(fault_rows().begin(), fault_rows().end()),
                         [](const auto& test) { return fault_text(test.param); });

INSTANTIATE_TEST_SUITE_P(Table, EveryFault, testing::ValuesIn(faults_of_an_axis()),
                         [](const auto& test) { return fault_text(test.param); });

TEST(AxisFaults, AFaultWithOff3BrakesThenStaysInFaultUntilItIsAcknowledged) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1135, 3.6));  // half a second

  ASSERT_TRUE(drive.axis.raise(8702));
  EXPECT_EQ(drive.status() & kFaultMask, 0x000F);
  drive.run(0.25);
  EXPECT_NEAR(drive.rpm(), 500.0, 20.0);
  drive.run(0.5);
  EXPECT_EQ(drive.send(0x000F) & 0x006F, 0x0028);
  EXPECT_EQ(drive.state(), State::Fault);

  drive.send(0x0080);
  EXPECT_EQ(drive.status() & kFaultMask, 0x0040);
}

TEST(AxisFaults, AFaultWithOff1BrakesOnTheNormalRamp) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1121, 7.2));

  ASSERT_TRUE(drive.axis.raise(7220));
  drive.run(0.5);

  EXPECT_NEAR(drive.rpm(), 500.0, 10.0);
}

TEST(AxisFaults, ALaterFaultCanSharpenTheReactionButNotSoftenIt) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.write(1135, 3.6));

  ASSERT_TRUE(drive.axis.raise(7220));  // OFF1, 10 s
  drive.run(0.1);
  ASSERT_TRUE(drive.axis.raise(8702));  // OFF3, half a second
  ASSERT_TRUE(drive.axis.raise(7403));  // OFF1 again
  drive.run(0.25);
  EXPECT_NEAR(drive.rpm(), 1000.0 - 72.0 - 500.0, 15.0);
  ASSERT_TRUE(drive.axis.raise(30001));  // OFF2
  EXPECT_EQ(drive.state(), State::Fault);
  EXPECT_FALSE(drive.axis.actual().pulses_enabled);
  EXPECT_EQ(drive.axis.messages().faults().size(), 4u);
}

TEST(AxisFaults, AreNotAcknowledgedDuringTheReaction) {
  TestAxis drive;
  drive.turn_at(1000.0);
  ASSERT_TRUE(drive.axis.raise(7220));

  EXPECT_FALSE(drive.axis.acknowledge());
  drive.send(0x008F);

  EXPECT_EQ(drive.state(), State::FaultReactionActive);
  EXPECT_EQ(drive.axis.messages().faults().size(), 1u);
}

TEST(AxisFaults, NeedARisingEdgeOfTheAcknowledgeBit) {
  TestAxis drive;
  drive.send(0x0080);
  ASSERT_TRUE(drive.axis.raise(7860));

  drive.send(0x0080);
  EXPECT_EQ(drive.state(), State::Fault);
  drive.send(0x0000);
  EXPECT_EQ(drive.state(), State::Fault);
  drive.send(0x0080);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
}

TEST(AxisFaults, AreNotAcknowledgedWhileTheirCauseIsThere) {
  TestAxis drive;
  drive.send(0x0000);
  ASSERT_TRUE(drive.axis.raise(7011, 0, Cause::Present));

  drive.send(0x0080);
  EXPECT_EQ(drive.state(), State::Fault);
  drive.axis.withdraw(7011);
  EXPECT_EQ(drive.state(), State::Fault);
  drive.send(0x0000);
  drive.send(0x0080);
  EXPECT_EQ(drive.state(), State::SwitchOnDisabled);
}

TEST(AxisFaults, LeaveTheDriveInhibitedAsLongAsOnIsStillSet) {
  TestAxis drive;
  drive.turn_at(100.0);
  ASSERT_TRUE(drive.axis.raise(7860));
  drive.run(1.0);

  EXPECT_EQ(drive.send(0x008F), 0x1670);
  drive.send(0x000F);
  drive.run(0.5);
  EXPECT_EQ(drive.status(), 0x1670);
  EXPECT_EQ(drive.send(0x0006), 0x1631);
}

TEST(AxisFaults, ShowSwitchOnDisabledForACycleEvenIfTheWordAlreadySaysShutdown) {
  TestAxis drive;
  drive.send(0x0006);
  ASSERT_TRUE(drive.axis.raise(7860));

  EXPECT_EQ(drive.send(0x0086), 0x1670);
  EXPECT_EQ(drive.send(0x0086), 0x1631);
}

TEST(AxisFaults, TheAbortConnectionOptionChoosesTheReactionToACommunicationError) {
  struct Case {
    int option;
    State state;
  };
  for (const Case& expected : {Case{0, State::OperationEnabled}, Case{1, State::FaultReactionActive},
                               Case{2, State::Fault}, Case{3, State::FaultReactionActive}}) {
    TestAxis drive;
    ASSERT_TRUE(drive.axis.write(8641, expected.option));
    drive.turn_at(1000.0);

    ASSERT_TRUE(drive.axis.raise(8700, 2));
    drive.run(TestAxis::kCycle);

    EXPECT_EQ(drive.state(), expected.state) << expected.option;
    EXPECT_NE(drive.status() & 0x0008, 0) << expected.option;
    // Option 3 brakes at the torque limit, option 1 on the ramp of 10 s.
    EXPECT_EQ(drive.rpm() < 950.0, expected.option == 3) << expected.option;
  }
}

TEST(AxisFaults, BeyondTheEighthStillSwitchOff) {
  TestAxis drive;
  drive.turn_at(100.0);
  int entered = 0;
  for (const FaultRow& row : fault_rows())
    if (row.kind == Kind::Fault && row.reaction == Reaction::Off1 && entered < 8) {
      ASSERT_TRUE(drive.axis.raise(row.number));
      ++entered;
    }
  ASSERT_EQ(drive.state(), State::FaultReactionActive);

  ASSERT_TRUE(drive.axis.raise(30001));

  EXPECT_EQ(drive.axis.messages().faults().size(), 8u);
  EXPECT_EQ(drive.state(), State::Fault);
}

TEST(AxisFaults, AnUnknownNumberIsRefused) {
  TestAxis drive;

  EXPECT_EQ(drive.axis.raise(12345).error(), FaultError::Unknown);
  EXPECT_EQ(drive.axis.messages().change_count(), 0u);
}

}  // namespace
}  // namespace drive
