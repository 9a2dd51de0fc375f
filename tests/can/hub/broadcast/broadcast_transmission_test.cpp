#include <cerrno>

#include "tests/can/hub/broadcast/broadcast_fixture.hpp"

namespace {

using canopen::kNever;
using told::kStart;
using namespace std::chrono_literals;

class BroadcastTransmission : public told::BroadcastFixture {
 protected:
  /// Sends 123#01 every 10 ms.
  int start_cycle(std::uint32_t flags = 0) {
    return ask({.opcode = TX_SETUP,
                .id = "123",
                .flags = SETTIMER | STARTTIMER | flags,
                .frames = {"123#01"},
                .second = 10ms});
  }
};

TEST_F(BroadcastTransmission, SendsAtOnceAndThenOnceAnInterval) {
  EXPECT_EQ(start_cycle(), 0);
  EXPECT_EQ(sent(), Texts{"123#01"});

  run_until(9999us);
  EXPECT_EQ(sent(), Texts{});
  run_until(10ms);
  EXPECT_EQ(sent(), Texts{"123#01"});
  run_until(50ms);
  EXPECT_EQ(sent().size(), 4u);
}

TEST_F(BroadcastTransmission, DoesNotDriftWhenItIsCalledLate) {
  start_cycle();

  manager.on_time(kStart + 13ms);
  EXPECT_EQ(manager.next_deadline(), kStart + 20ms);
  manager.on_time(kStart + 20ms);
  EXPECT_EQ(manager.next_deadline(), kStart + 30ms);
}

TEST_F(BroadcastTransmission, SendsNoBurstForIntervalsThatWereMissed) {
  start_cycle();
  sent();

  manager.on_time(kStart + 55ms);

  EXPECT_EQ(sent(), Texts{"123#01"});
  EXPECT_EQ(manager.next_deadline(), kStart + 60ms);
}

TEST_F(BroadcastTransmission, SendsCountedFramesAtTheFirstIntervalAndTheRestAtTheSecond) {
  ask({.opcode = TX_SETUP,
       .id = "123",
       .flags = SETTIMER | STARTTIMER,
       .frames = {"123#"},
       .count = 3,
       .first = 1ms,
       .second = 100ms});
  EXPECT_EQ(sent().size(), 1u);  // counts, too

  run_until(2ms);
  EXPECT_EQ(sent().size(), 2u);
  run_until(101ms);
  EXPECT_EQ(sent().size(), 0u);
  run_until(202ms);
  EXPECT_EQ(sent().size(), 2u);
}

TEST_F(BroadcastTransmission, TellsWhenTheCountHasExpiredIfAsked) {
  ask({.opcode = TX_SETUP,
       .id = "123",
       .flags = SETTIMER | STARTTIMER | TX_COUNTEVT,
       .frames = {"123#"},
       .count = 2,
       .first = 1ms});
  EXPECT_EQ(told.take(), Texts{});

  run_until(1s);

  EXPECT_EQ(told.take(), Texts{"TX_EXPIRED 123:"});
  EXPECT_EQ(told.last()->ival1.tv_usec, 1000);
  EXPECT_EQ(told.interface_index, 0);
  EXPECT_EQ(sent().size(), 2u);
  EXPECT_EQ(manager.next_deadline(), kNever);
}

TEST_F(BroadcastTransmission, DoesNotTellWhenTheFirstFrameWasTheOnlyOneToCount) {
  ask({.opcode = TX_SETUP,
       .id = "123",
       .flags = SETTIMER | STARTTIMER | TX_COUNTEVT,
       .frames = {"123#"},
       .count = 1,
       .first = 1ms});

  run_until(1s);

  EXPECT_EQ(told.take(), Texts{});
  EXPECT_EQ(sent().size(), 1u);
}

TEST_F(BroadcastTransmission, SendsItsFramesInTurn) {
  ask({.opcode = TX_SETUP,
       .id = "123",
       .flags = SETTIMER | STARTTIMER,
       .frames = {"123#01", "456#02", "789#03"},
       .second = 1ms});

  run_until(3ms);

  EXPECT_EQ(sent(), (Texts{"123#01", "456#02", "789#03", "123#01"}));
}

TEST_F(BroadcastTransmission, PutsItsIdentifierIntoFramesIfAsked) {
  ask({.opcode = TX_SETUP, .id = "123", .flags = TX_ANNOUNCE | TX_CP_CAN_ID, .frames = {"456#02"}});

  EXPECT_EQ(sent(), Texts{"123#02"});
}

TEST_F(BroadcastTransmission, OnlyKeepsFramesWithoutTimerAndAnnouncement) {
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .frames = {"123#01"}}), 0);

  EXPECT_EQ(sent(), Texts{});
  EXPECT_EQ(manager.next_deadline(), kNever);
}

TEST_F(BroadcastTransmission, ChangesContentWithoutTouchingTheCycle) {
  start_cycle();
  sent();
  run_until(4ms);

  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .frames = {"123#FF"}}), 0);

  EXPECT_EQ(sent(), Texts{});
  EXPECT_EQ(manager.next_deadline(), kStart + 10ms);
  run_until(10ms);
  EXPECT_EQ(sent(), Texts{"123#FF"});
}

TEST_F(BroadcastTransmission, AnnouncesNewContentIfAskedAndKeepsTheCycle) {
  start_cycle();
  sent();
  run_until(4ms);

  ask({.opcode = TX_SETUP, .id = "123", .flags = TX_ANNOUNCE, .frames = {"123#FF"}});

  EXPECT_EQ(sent(), Texts{"123#FF"});
  EXPECT_EQ(manager.next_deadline(), kStart + 10ms);
}

TEST_F(BroadcastTransmission, TakesANewIntervalFromTheNextFrameOn) {
  start_cycle();

  ask({.opcode = TX_SETUP, .id = "123", .flags = SETTIMER, .frames = {"123#01"}, .second = 3ms});

  EXPECT_EQ(manager.next_deadline(), kStart + 10ms);
  run_until(10ms);
  EXPECT_EQ(manager.next_deadline(), kStart + 13ms);
}

TEST_F(BroadcastTransmission, StopsWhenBothIntervalsBecomeZero) {
  start_cycle();

  ask({.opcode = TX_SETUP, .id = "123", .flags = SETTIMER, .frames = {"123#01"}});

  EXPECT_EQ(manager.next_deadline(), kNever);
}

TEST_F(BroadcastTransmission, GoesOnInTheSequenceUnlessAskedToBeginAnew) {
  const told::Asked two{.opcode = TX_SETUP, .id = "123", .flags = TX_ANNOUNCE, .frames = {"123#01", "123#02"}};
  ask(two);
  ask(two);
  ask(two);
  EXPECT_EQ(sent(), (Texts{"123#01", "123#02", "123#01"}));

  told::Asked again = two;
  again.flags |= TX_RESET_MULTI_IDX;
  ask(again);

  EXPECT_EQ(sent(), Texts{"123#01"});
}

TEST_F(BroadcastTransmission, MayShrinkItsSequenceButNotGrowIt) {
  ask({.opcode = TX_SETUP, .id = "123", .frames = {"123#01", "123#02"}});

  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .frames = {"123#01", "123#02", "123#03"}}), E2BIG);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .frames = {"123#01"}}), 0);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .frames = {"123#01", "123#02"}}), E2BIG);
}

TEST_F(BroadcastTransmission, IsReadWithWhatIsLeftOfItsCount) {
  ask({.opcode = TX_SETUP,
       .id = "123",
       .flags = SETTIMER | STARTTIMER,
       .frames = {"123#01", "123#02"},
       .count = 5,
       .first = 1ms,
       .second = 2s});
  run_until(1ms);

  EXPECT_EQ(ask({.opcode = TX_READ, .id = "123"}), 0);

  EXPECT_EQ(told.take(), Texts{"TX_STATUS 123: 123#01 123#02"});
  EXPECT_EQ(told.last()->count, 3u);
  EXPECT_EQ(told.last()->ival2.tv_sec, 2);
  EXPECT_EQ(told.last()->flags, std::uint32_t{SETTIMER | STARTTIMER | TX_ANNOUNCE});
}

TEST_F(BroadcastTransmission, EndsWhenItIsDeleted) {
  start_cycle();

  EXPECT_EQ(ask({.opcode = TX_DELETE, .id = "123"}), 0);

  EXPECT_EQ(manager.next_deadline(), kNever);
  EXPECT_EQ(ask({.opcode = TX_DELETE, .id = "123"}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_READ, .id = "123"}), EINVAL);
}

TEST_F(BroadcastTransmission, IsToldApartByIdentifierFormatAndInterface) {
  start_cycle();

  EXPECT_EQ(ask({.opcode = TX_DELETE, .id = "00000123"}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_DELETE, .id = "123#R"}), EINVAL);
  EXPECT_EQ(manager.request(told::message({.opcode = TX_DELETE, .id = "123"}), kIndex + 1, now), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_DELETE, .id = "123"}), 0);
}

TEST_F(BroadcastTransmission, GoesOnWithItsCycleThoughTheBusHasNoRoom) {
  hub::Medium slow{10'000};
  hub::BroadcastManager on_slow{slow, told};
  on_slow.request(
      told::message(
          {.opcode = TX_SETUP, .id = "123", .flags = SETTIMER | STARTTIMER, .frames = {"123#01"}, .second = 1ms}),
      kIndex, now);
  for (int i = 0; i < 100; ++i) on_slow.on_time(on_slow.next_deadline());

  EXPECT_EQ(on_slow.next_deadline(), kStart + 101ms);
}

}  // namespace
