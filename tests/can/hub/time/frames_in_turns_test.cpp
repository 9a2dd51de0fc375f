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
  first.send("300#");
  first.wait(0, 0);
  ASSERT_EQ(first.turn(), 0);
  second.want();
  first.send("200#");
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

TEST_F(FramesInTurns, FindRoomAtTheSameInstantsInEveryRun) {
  int sent = 0;
  while (first.send("123#")) ++sent;
  EXPECT_GE(sent, 8);
  first.wait(0, kNoInstant);
  ASSERT_EQ(first.turn(), 0);  // the hub has taken them
  int more = 0;
  while (first.send("123#")) ++more;
  EXPECT_EQ(more, sent);
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
  }
}

TEST_F(FramesInTurns, ThatWereNotReadComeInATurnLater) {
  constexpr int kFrames = 400;  // more than the socket holds
  first.wait(0, kNoInstant);
  const BusClient outsider{hub.path()};
  second.want();
  ASSERT_EQ(second.turn(), 0);
  for (int i = 0; i < kFrames; ++i) {
    while (!second.send("123#")) {
      second.wait(second.last().now_ns, kNoInstant);
      ASSERT_GE(second.turn(), 0);
    }
  }
  second.wait(second.last().now_ns, kNoInstant);
  std::size_t read = 0;
  while (read < kFrames) {
    const std::int64_t now = first.turn();
    ASSERT_GE(now, 0);
    for (std::size_t count = 1; count != 0; read += count) count = first.take_frames().size();
    first.wait(now, kNoInstant);
  }
  EXPECT_EQ(read, static_cast<std::size_t>(kFrames));
}

}  // namespace
}  // namespace hub_test
