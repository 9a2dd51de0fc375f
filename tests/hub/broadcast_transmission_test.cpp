#include <cerrno>

#include "tests/hub/broadcast_fixture.hpp"

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

TEST_F(BroadcastTransmission, SendsOneFrameAtOnce) {
  EXPECT_EQ(ask({.opcode = TX_SEND, .frames = {"705#R"}}), 0);

  EXPECT_EQ(sent(), Texts{"705#R"});
  EXPECT_EQ(other.passages.back().sender, &manager);
  EXPECT_EQ(other.passages.back().interface_index, kIndex);
}

TEST_F(BroadcastTransmission, SaysThatTheBusHasNoRoom) {
  hub::Medium slow{10'000};
  hub::BroadcastManager on_slow{slow, told};
  const auto send = told::message({.opcode = TX_SEND, .frames = {"123#01"}});
  int error = 0;
  for (std::size_t i = 0; i < hub::Medium::kQueue + 1; ++i) EXPECT_EQ(on_slow.request(send, kIndex, now), 0);

  error = on_slow.request(send, kIndex, now);

  EXPECT_EQ(error, ENOBUFS);
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

TEST_F(BroadcastTransmission, NeedsAnInterface) {
  EXPECT_EQ(manager.request(told::message({.opcode = TX_SETUP, .frames = {"123#"}}), 0, now), ENODEV);
  EXPECT_EQ(manager.request(told::message({.opcode = TX_SEND, .frames = {"123#"}}), 0, now), ENODEV);
}

TEST_F(BroadcastTransmission, RefusesWhatIsMalformed) {
  const auto complete = told::message({.opcode = TX_SETUP, .id = "123", .frames = {"123#"}});
  const std::span bytes{complete};
  EXPECT_EQ(manager.request({}, kIndex, now), EINVAL);
  EXPECT_EQ(manager.request(bytes.first(sizeof(bcm_msg_head) - 1), kIndex, now), EINVAL);
  EXPECT_EQ(manager.request(bytes.first(bytes.size() - 1), kIndex, now), EINVAL);
  EXPECT_EQ(manager.request(bytes.first(sizeof(bcm_msg_head)), kIndex, now), EFAULT);

  EXPECT_EQ(ask({.opcode = 0, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_STATUS, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = RX_CHANGED + 1, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123"}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .frames = Texts(257, "123#")}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "123", .flags = CAN_FD_FRAME, .frames = {"123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SEND, .frames = {"123#", "123#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = TX_SEND}), EINVAL);
  EXPECT_EQ(sent(), Texts{});
  EXPECT_EQ(ask({.opcode = TX_READ, .id = "123"}), EINVAL);  // nothing of it was kept
}

TEST_F(BroadcastTransmission, RefusesADataLengthAboveEight) {
  auto bytes = told::message({.opcode = TX_SETUP, .id = "123", .frames = {"123#"}});
  bytes[sizeof(bcm_msg_head) + offsetof(can_frame, can_dlc)] = std::byte{9};

  EXPECT_EQ(manager.request(bytes, kIndex, now), EINVAL);
  reinterpret_cast<bcm_msg_head*>(bytes.data())->opcode = TX_SEND;
  EXPECT_EQ(manager.request(bytes, kIndex, now), EINVAL);
}

TEST_F(BroadcastTransmission, RefusesIntervalsThatAreNoneButOnlyIfTheyAreUsed) {
  for (const bcm_timeval wrong : {bcm_timeval{-1, 0}, {0, -1}, {0, 1'000'000}, {400L * 86'400 + 1, 0}}) {
    auto bytes = told::message({.opcode = TX_SETUP, .id = "123", .flags = SETTIMER, .frames = {"123#"}});
    auto* const head = reinterpret_cast<bcm_msg_head*>(bytes.data());
    head->ival2 = wrong;
    EXPECT_EQ(manager.request(bytes, kIndex, now), EINVAL) << wrong.tv_sec << " s " << wrong.tv_usec << " us";
    head->flags = 0;
    EXPECT_EQ(manager.request(bytes, kIndex, now), 0);
  }
}

TEST_F(BroadcastTransmission, HoldsNoMoreOperationsThanAllowed) {
  char id[16];
  for (unsigned i = 0; i < hub::BroadcastManager::kMostOperations; ++i) {
    std::snprintf(id, sizeof id, "%08X", i);
    ASSERT_EQ(ask({.opcode = i % 2 == 0 ? TX_SETUP : RX_SETUP, .id = id, .frames = {"123#"}}), 0);
  }

  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "7FF", .frames = {"123#"}}), ENOMEM);
  EXPECT_EQ(ask({.opcode = TX_SETUP, .id = "00000000", .frames = {"123#"}}), 0);
}

}  // namespace
