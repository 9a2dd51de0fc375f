#include <csignal>

#include <gtest/gtest.h>

#include "tests/can/hub/time/clock_program.hpp"
#include "tests/can/hub/time/hub_with_turns.hpp"

namespace hub_test {
namespace {

using userbus::kChildEnded;
using userbus::kNoInstant;

/// Two programs; the first has its turn.
class EndedPrograms : public testing::Test {
 protected:
  void SetUp() override {
    first.join();
    ASSERT_EQ(first.turn(), 0);
    second.join();
  }

  HubWithTurns hub;
  ClockProgram first{hub.path()}, second{hub.path()};
};

TEST_F(EndedPrograms, LoseTheirTurnAndEverybodyLooks) {
  first.exit();
  ASSERT_EQ(second.turn(), 0);
  EXPECT_EQ(second.last().horizon_ns, kLast);
  EXPECT_EQ(second.last().flags, 0U);
}

TEST_F(EndedPrograms, AreSeenBetweenTheirTurns) {
  first.wait(0, 9000);
  ASSERT_EQ(second.turn(), 0);
  second.wait(0, kNoInstant);
  ASSERT_EQ(first.turn(), 9000);
  second.signal(SIGKILL);
  first.wait(9000, kNoInstant);
  EXPECT_EQ(first.turn(), 9000);
}

TEST_F(EndedPrograms, HaveSentWhatTheySentBefore) {
  first.open();
  first.wait(0, kNoInstant);
  ASSERT_EQ(second.turn(), 0);
  second.open();
  second.send("123#", 4000);
  second.exit();
  ASSERT_EQ(first.turn(), 4000);
  first.wait(4000, kNoInstant);
  ASSERT_GT(first.turn(), 4000);
  EXPECT_EQ(first.take_frames().size(), 1U);
}

TEST_F(EndedPrograms, AreToldToTheirParents) {
  first.start({.until = 5000});
  first.wait(0, kNoInstant);
  ASSERT_EQ(second.turn(), 0);
  second.wait(0, 8000);
  ASSERT_EQ(first.turn(), 5000);
  EXPECT_EQ(first.last().flags, kChildEnded);
  first.wait(5000, kNoInstant);
  ASSERT_EQ(second.turn(), 5000);
  EXPECT_EQ(second.last().flags, 0U);
}

TEST_F(EndedPrograms, HoldTimeThoughTheyHaveNotSaidWhoTheyAre) {
  first.start({.says_who_it_is = false});
  first.wait(0, 7000);
  ASSERT_EQ(second.turn(), 0);
  second.wait(0, 9000);
  ASSERT_EQ(first.turn(), 0);
  EXPECT_EQ(first.last().flags, kChildEnded);
}

TEST_F(EndedPrograms, AreNoneIfTheyGoOnByAnotherConnection) {
  first.replace();
  ASSERT_EQ(second.turn(), 0);
  second.wait(0, 1000);
  ASSERT_EQ(first.turn(), 0);
  EXPECT_EQ(first.last().flags, 0U);
  EXPECT_EQ(first.last().horizon_ns, 1000);
}

TEST_F(EndedPrograms, HadChildrenWhoHaveTheirSockets) {
  first.open();
  first.start({});
  first.wait(0, kNoInstant);
  ASSERT_EQ(second.turn(), 0);
  second.open();
  second.send("123#");
  first.exit();
  second.wait(0, kNoInstant);
  // first has ended: all look, then the child of first is given the frame
  ASSERT_GE(second.turn(), 0);
  second.wait(0, 1'000'000);
  EXPECT_EQ(second.turn(), 1'000'000);
}

}  // namespace
}  // namespace hub_test
