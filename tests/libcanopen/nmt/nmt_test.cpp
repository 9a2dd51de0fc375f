#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

using canopen::NmtState;
using canopen::Policy;

using Nmt = NodeTest;

TEST_F(Nmt, IsSilentBeforeStart) {
  for (const char* const frame : {"605#4000100000000000", "000#0105", "000#8105", "080#", "205#0F00"}) {
    EXPECT_EQ(says(frame), Lines{}) << frame;
  }

  EXPECT_EQ(node->state(), NmtState::Initialising);
  EXPECT_TRUE(subscriptions().empty());
}

TEST_F(Nmt, StaysSilentBeforeStartWhateverIsWrittenToTheDictionary) {
  ASSERT_TRUE(dictionary.write(**dictionary.find(0x1017, 0), 100));
  ASSERT_TRUE(dictionary.write(**dictionary.find(0x1800, 1), 0x40000195));

  EXPECT_EQ(says("000#0105"), Lines{});
  EXPECT_EQ(says("605#4000100000000000"), Lines{});
  node->on_time(now + 1s);

  EXPECT_EQ(sent(), Lines{});
  EXPECT_EQ(node->state(), NmtState::Initialising);
}

TEST_F(Nmt, WaitsForNothingBeforeStart) {
  ASSERT_TRUE(dictionary.write(**dictionary.find(0x1017, 0), 100));

  node->on_time(now);
  EXPECT_EQ(node->next_deadline(), canopen::kNever);

  start();
  EXPECT_EQ(passes(100ms), (Lines{"100ms 705#7F"}));
}

TEST_F(Nmt, BootsToPreOperationalWithABootUpFrame) {
  EXPECT_EQ(start(), (Lines{"705#00"}));

  EXPECT_EQ(node->state(), NmtState::PreOperational);
  EXPECT_EQ(application.told, (Lines{"Initialising -> Pre-operational"}));
  EXPECT_EQ(application.subscription_changes, 1);
}

TEST_F(Nmt, FollowsTheFiveCommandsFromEveryState) {
  struct Row {
    const char* command;
    NmtState state;
    bool boots;
  };
  const Row rows[] = {
      {"000#0105", NmtState::Operational, false},    {"000#0205", NmtState::Stopped, false},
      {"000#8005", NmtState::PreOperational, false}, {"000#8105", NmtState::PreOperational, true},
      {"000#8205", NmtState::PreOperational, true},
  };
  start();
  for (const char* const from : {"000#0105", "000#0205", "000#8005"}) {
    for (const Row& row : rows) {
      says(from);
      const Lines lines = says(row.command);
      EXPECT_EQ(node->state(), row.state) << from << " then " << row.command;
      EXPECT_EQ(std::ranges::count(lines, "705#00"), row.boots ? 1 : 0) << from << " then " << row.command;
    }
  }
}

TEST_F(Nmt, ListensToItsNodeIdAndToAll) {
  start();

  says("000#0106");
  EXPECT_EQ(node->state(), NmtState::PreOperational);
  says("000#0100");
  EXPECT_EQ(node->state(), NmtState::Operational);
}

TEST_F(Nmt, IgnoresCommandsThatAreNotTwoBytesLong) {
  start();

  for (const char* const frame : {"000#", "000#01", "000#010500", "000#0105000000000000", "000#R2"}) {
    says(frame);
    EXPECT_EQ(node->state(), NmtState::PreOperational) << frame;
  }
}

TEST_F(Nmt, IgnoresUnknownCommandsByDefault) {
  start_operational();

  for (const char* const frame : {"000#0005", "000#0305", "000#7F05", "000#8305", "000#FF05"}) {
    says(frame);
    EXPECT_EQ(node->state(), NmtState::Operational) << frame;
  }
}

class NmtThatStops : public NodeTest {
 protected:
  NmtThatStops() : NodeTest{Policy{.unknown_command = canopen::UnknownCommand::Stop}} {}
};

TEST_F(NmtThatStops, EntersStoppedOnAnUnknownCommandToItself) {
  start_operational();

  says("000#FF06");
  EXPECT_EQ(node->state(), NmtState::Operational);
  says("000#FF05");
  EXPECT_EQ(node->state(), NmtState::Stopped);
}

class NmtThatRuns : public NodeTest {
 protected:
  NmtThatRuns() : NodeTest{Policy{.start_state = NmtState::Operational}} {}
};

TEST_F(NmtThatRuns, EntersItsStartStateAfterTheBootUpFrame) {
  EXPECT_EQ(start(), (Lines{"705#00", "185#4000"}));
  EXPECT_EQ(node->state(), NmtState::Operational);

  EXPECT_EQ(says("000#8205"), (Lines{"705#00", "185#4000"}));
  EXPECT_EQ(node->state(), NmtState::Operational);
}

TEST_F(NmtThatRuns, LeavesOperationalWhenItIsStartedAgain) {
  start();
  application.told.clear();

  EXPECT_EQ(start(), (Lines{"705#00", "185#4000"}));

  EXPECT_EQ(application.told, (Lines{"Operational -> Pre-operational", "Pre-operational -> Operational"}));
  EXPECT_EQ(sets(0x6041, 7), (Lines{"185#0700"})) << "TPDOs run again";
}

TEST_F(Nmt, ResetNodeRestoresCommunicationAndApplicationObjects) {
  start();
  writes_u16(0x1017, 0, 500);
  writes(0x2000, 0, 3, 1);
  writes_u16(0xA000, 0, 7);
  application.told.clear();

  says("000#8105");

  EXPECT_EQ(value_of(0x1017), 0);
  EXPECT_EQ(value_of(0x2000), -9);
  EXPECT_EQ(value_of(0xA000), 7);
  EXPECT_EQ(application.told,
            (Lines{"Pre-operational -> Initialising", "reset 129", "Initialising -> Pre-operational"}));
}

TEST_F(Nmt, ResetCommunicationLeavesApplicationObjectsAlone) {
  start();
  writes_u16(0x1017, 0, 500);
  writes(0x2000, 0, 3, 1);

  says("000#8205");

  EXPECT_EQ(value_of(0x1017), 0);
  EXPECT_EQ(value_of(0x2000), 3);
}

TEST_F(Nmt, RunsOnlyTheServicesOfItsState) {
  constexpr const char* kRead = "605#4018100100000000";
  const Lines answer{"585#431810012A000000"};
  start();

  EXPECT_EQ(says(kRead), answer);
  says("205#FF00");
  EXPECT_EQ(value_of(0x6040), 1);

  EXPECT_EQ(says("000#0105"), (Lines{"185#4000"}));
  EXPECT_EQ(says(kRead), answer);
  says("205#FF00");
  EXPECT_EQ(value_of(0x6040), 0xFF);

  says("000#0205");
  EXPECT_EQ(says(kRead), Lines{});
  says("205#0000");
  EXPECT_EQ(value_of(0x6040), 0xFF);
  EXPECT_EQ(sets(0x6041, 0x1234), Lines{});
  EXPECT_EQ(says("080#"), Lines{});
  EXPECT_EQ(passes(1h), Lines{});
}

TEST_F(Nmt, ForgetsAHalfFinishedTransferWhenItStops) {
  start();
  says("605#4008100000000000");

  says("000#0205");
  EXPECT_EQ(passes(1min), Lines{});
  says("000#8005");

  EXPECT_EQ(says("605#6000000000000000"), (Lines{"585#8000000001000405"}));
}

TEST_F(Nmt, ObeysItsOwnerAsItObeysTheMaster) {
  node->command(canopen::NmtCommand::Start, now);
  EXPECT_EQ(node->state(), NmtState::Initialising) << "before start()";
  start();

  node->command(canopen::NmtCommand::Start, now);
  EXPECT_EQ(sent(), Lines{"185#4000"});
  EXPECT_EQ(node->state(), NmtState::Operational);

  node->command(canopen::NmtCommand::ResetNode, now);
  EXPECT_EQ(sent(), Lines{"705#00"});
  EXPECT_EQ(node->state(), NmtState::PreOperational);
}

}  // namespace
