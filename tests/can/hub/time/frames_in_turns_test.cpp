#include <array>
#include <cstring>

#include <gtest/gtest.h>
#include <linux/can/bcm.h>

#include "tests/can/hub/time/clock_program.hpp"
#include "tests/can/hub/time/hub_with_turns.hpp"
#include "tests/can/hub/told.hpp"

namespace hub_test {
namespace {

using userbus::kNoInstant;
using Frames = std::vector<std::string>;

/// Two programs with a socket each, the first of which has its turn.
class FramesInTurns : public testing::Test {
 protected:
  void SetUp() override {
    first.join();
    ASSERT_EQ(first.turn(), 0);
    first.open();
    second.join();
    first.wait(0, kNoInstant);
    ASSERT_EQ(second.turn(), 0);
    second.open();
    second.wait(0, kNoInstant);
    first.want();
    ASSERT_EQ(first.turn(), 0);
  }

  HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
};

TEST_F(FramesInTurns, LastAsLongAsTheirBits) {
  first.send("123#1122334455667788");
  first.wait(0, kNoInstant);
  ASSERT_EQ(second.turn(), 112'000);
  EXPECT_EQ(second.take_frames(), Frames{"112 123#1122334455667788"});
}

TEST_F(FramesInTurns, CompeteByIdentifierAtOneInstant) {
  second.want();
  first.send("300#");
  first.wait(0, kNoInstant);
  ASSERT_EQ(second.turn(), 0);
  second.send("100#");
  second.wait(0, kNoInstant);
  ASSERT_EQ(first.turn(), 51'000);
  EXPECT_EQ(first.take_frames(), Frames{"51 100#"});
  first.wait(51'000, kNoInstant);
  ASSERT_EQ(second.turn(), 102'000);
  EXPECT_EQ(second.take_frames(), Frames{"102 300#"});
}

TEST_F(FramesInTurns, CompeteThoughTheFirstSenderCameToTheInstantByItself) {
  second.want();
  first.wait(0, 500'000);
  ASSERT_EQ(second.turn(), 0);
  EXPECT_EQ(second.last().horizon_ns, 500'000);
  second.send("300#", 500'000);
  second.wait(500'000, kNoInstant);
  ASSERT_EQ(first.turn(), 500'000);
  first.send("100#");
  first.wait(500'000, kNoInstant);
  ASSERT_EQ(second.turn(), 551'000);
  EXPECT_EQ(second.take_frames(), Frames{"551 100#"});
}

TEST_F(FramesInTurns, BeginWhenTheirSenderGivesWay) {
  first.send("300#");
  first.wait(0, 0);
  ASSERT_EQ(first.turn(), 0);
  first.send("100#");
  first.wait(0, kNoInstant);
  ASSERT_EQ(second.turn(), 51'000);
  EXPECT_EQ(second.take_frames(), Frames{"51 300#"});
}

TEST_F(FramesInTurns, BeginAtThePresentOfWhoSendsThem) {
  first.send("123#1122334455667788", 1'000'000);
  first.wait(1'000'000, kNoInstant);
  ASSERT_EQ(second.turn(), 1'112'000);
  EXPECT_EQ(second.take_frames(), Frames{"1112 123#1122334455667788"});
}

TEST_F(FramesInTurns, AreAnsweredAtTheInstantOfTheirEnd) {
  first.send("601#4000100000000000");
  first.send("700#");
  first.wait(0, kNoInstant);
  const std::int64_t asked = second.turn();
  second.send("581#4300100092010200");
  second.wait(asked, kNoInstant);
  ASSERT_GT(first.turn(), asked);
  EXPECT_EQ(first.take_frames().back().substr(4), "581#4300100092010200");
}

TEST_F(FramesInTurns, CompeteAsAnswersWithWhatHasWaited) {
  first.send("601#");
  first.send("700#1122334455667788");
  first.wait(0, kNoInstant);
  const std::int64_t end = second.turn();
  second.send("581#");
  second.wait(end, kNoInstant);
  EXPECT_LT(first.turn(), end + 60'000);
  const Frames seen = first.take_frames();
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_TRUE(seen.front().ends_with(" 581#")) << seen.front();
}

/// Frames that a program can send before its socket is full.
int fill(const ClockProgram& program) {
  int sent = 0;
  while (program.send("123#")) ++sent;
  return sent;
}

TEST_F(FramesInTurns, FindTheSameRoomHoweverQuickTheHubIs) {
  EXPECT_EQ(fill(first), userbus::kQueueOfTurns);
  first.wait(0, kNoInstant);
  ASSERT_EQ(first.turn(), 0);
  EXPECT_EQ(fill(first), 18);  // as many are on the bus now, or wait for it
}

TEST_F(FramesInTurns, AreNotInTheWayOfRequests) {
  fill(first);
  first.wait(0, kNoInstant);
  ASSERT_EQ(first.turn(), 0);
  fill(first);
  first.settle();  // though the bus has no room for what was sent before
  first.wait(0, kNoInstant);
  EXPECT_EQ(second.turn(), 48'000);
}

TEST_F(FramesInTurns, AreSentByTheBroadcastManagerInTheTimeOfTheBus) {
  const BusClient timer{hub.path(), "vcan0", userbus::Kind::BroadcastManager};
  std::array<std::byte, sizeof(bcm_msg_head) + sizeof(can_frame)> message{};
  bcm_msg_head head{};
  head.opcode = TX_SETUP;
  head.flags = SETTIMER | STARTTIMER;
  head.ival2 = {.tv_sec = 0, .tv_usec = 10'000};
  head.can_id = 0x80;
  head.nframes = 1;
  const can_frame frame = told::wire("080#");
  std::memcpy(message.data(), &head, sizeof head);
  std::memcpy(&message[sizeof head], &frame, sizeof frame);
  ASSERT_EQ(timer.ask(userbus::Operation::Broadcast, 0, message).error, 0);

  first.wait(0, kNoInstant);
  for (const char* const seen : {"51 080#", "10051 080#", "20051 080#"}) {
    const std::int64_t now = first.turn();
    EXPECT_EQ(first.take_frames(), Frames{seen});
    first.wait(now, kNoInstant);
    EXPECT_EQ(second.turn(), now);
    second.wait(now, kNoInstant);
  }
}

TEST(FramesThatAreNotRead, ComeInALaterTurn) {
  const HubWithTurns hub;
  ClockProgram reader{hub.path()};
  const BusClient sender{hub.path()};
  reader.join();
  std::int64_t now = reader.turn();
  reader.open();
  constexpr std::size_t kFrames = 400;  // more than a socket holds
  for (std::size_t i = 0; i < kFrames; ++i) {
    sender.send("123#");
    reader.wait(now, kNoInstant);
    now = reader.turn();
    ASSERT_GE(now, 0);
  }
  std::size_t read = reader.count_frames();
  EXPECT_LT(read, kFrames);
  while (read < kFrames) {
    reader.wait(now, kNoInstant);
    ASSERT_EQ(reader.turn(), now);
    read += reader.count_frames();
  }
  EXPECT_EQ(read, kFrames);
}

}  // namespace
}  // namespace hub_test
