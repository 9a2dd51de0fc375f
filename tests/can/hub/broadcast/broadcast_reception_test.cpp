#include <cerrno>

#include "tests/can/hub/broadcast/broadcast_fixture.hpp"

namespace {

using canopen::kNever;
using told::kStart;
using namespace std::chrono_literals;

class BroadcastReception : public told::BroadcastFixture {
 protected:
  void SetUp() override { EXPECT_EQ(told.take(), Texts{}); }
};

TEST_F(BroadcastReception, TellsEveryFrameOfItsIdentifierWithoutFilter) {
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "123"}), 0);

  for (const char* const frame : {"123#01", "123#01", "124#01", "00000123#01", "123#R"}) arrive(frame);

  EXPECT_EQ(told.take(), (Texts{"RX_CHANGED 123: 123#01", "RX_CHANGED 123: 123#01"}));
  EXPECT_EQ(told.last()->flags, std::uint32_t{RX_FILTER_ID});
  EXPECT_EQ(told.interface_index, kIndex);
}

TEST_F(BroadcastReception, IgnoresFramesBehindTheHeadIfOnlyTheIdentifierCounts) {
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "123", .flags = RX_FILTER_ID, .frames = {"123#FF", "123#FF"}}), 0);

  ask({.opcode = RX_READ, .id = "123"});

  EXPECT_EQ(told.take(), Texts{"RX_STATUS 123:"});
}

TEST_F(BroadcastReception, TellsOnlyChangesOfTheBitsOfItsMask) {
  ask({.opcode = RX_SETUP, .id = "123", .frames = {"123#F000"}});

  for (const char* const frame : {"123#1122", "123#1F33", "123#2F33"}) arrive(frame);

  EXPECT_EQ(told.take(), (Texts{"RX_CHANGED 123: 123#1122", "RX_CHANGED 123: 123#2F33"}));
}

TEST_F(BroadcastReception, TellsAChangeOfLengthOnlyIfAsked) {
  ask({.opcode = RX_SETUP, .id = "100", .frames = {"100#FF"}});
  ask({.opcode = RX_SETUP, .id = "200", .flags = RX_CHECK_DLC, .frames = {"200#FF"}});

  for (const char* const frame : {"100#01", "100#0100", "200#01", "200#0100", "200#"}) arrive(frame);

  EXPECT_EQ(told.take(), (Texts{"RX_CHANGED 100: 100#01", "RX_CHANGED 200: 200#01", "RX_CHANGED 200: 200#0100",
                                "RX_CHANGED 200: 200#"}));
}

TEST_F(BroadcastReception, ComparesMultiplexedContentByTheFilterThatFits) {
  // The first byte selects, the second is watched; for 01h its lower half only.
  ask({.opcode = RX_SETUP, .id = "123", .frames = {"123#FF00", "123#010F", "123#02FF"}});

  for (const char* const frame :
       {"123#0111", "123#0211", "123#0121", "123#0112", "123#0221", "123#0399", "123#0221"})
    arrive(frame);

  EXPECT_EQ(told.take(), (Texts{"RX_CHANGED 123: 123#0111", "RX_CHANGED 123: 123#0211", "RX_CHANGED 123: 123#0112",
                                "RX_CHANGED 123: 123#0221"}));
}

TEST_F(BroadcastReception, TakesA256thFilterBehindTheMask) {
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "123", .frames = Texts(257, "123#FF")}), 0);
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "124", .frames = Texts(258, "123#FF")}), EINVAL);

  ask({.opcode = RX_READ, .id = "123"});

  EXPECT_EQ(told.last()->nframes, 257u);
}

TEST_F(BroadcastReception, TellsOnceThatFramesStayAway) {
  ask({.opcode = RX_SETUP, .id = "123", .flags = SETTIMER | STARTTIMER | RX_FILTER_ID, .first = 10ms});

  run_until(1s);

  EXPECT_EQ(told.take(), Texts{"RX_TIMEOUT 123:"});
  EXPECT_EQ(told.last()->ival1.tv_usec, 10'000);
  EXPECT_EQ(manager.next_deadline(), kNever);
}

TEST_F(BroadcastReception, StartsItsTimeOutAnewWithEveryFrame) {
  ask({.opcode = RX_SETUP, .id = "123", .flags = SETTIMER, .frames = {"123#FF"}, .first = 10ms});
  run_until(1s);
  EXPECT_EQ(told.take(), Texts{});  // no frame yet, and STARTTIMER was not asked for

  arrive("123#01");
  run_until(1s + 8ms);
  arrive("123#01");
  run_until(1s + 17ms);
  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#01"});
  run_until(1s + 18ms);

  EXPECT_EQ(told.take(), Texts{"RX_TIMEOUT 123:"});
}

TEST_F(BroadcastReception, LeavesItsTimeOutStoppedAfterAFrameIfAsked) {
  ask({.opcode = RX_SETUP,
       .id = "123",
       .flags = SETTIMER | STARTTIMER | RX_FILTER_ID | RX_NO_AUTOTIMER,
       .first = 10ms});

  arrive("123#01");

  EXPECT_EQ(manager.next_deadline(), kNever);
}

TEST_F(BroadcastReception, AnnouncesTheSameContentAfterATimeOutOnlyIfAsked) {
  for (const std::uint32_t flag : {0U, std::uint32_t{RX_ANNOUNCE_RESUME}}) {
    ask({.opcode = RX_SETUP, .id = "123", .flags = SETTIMER | flag, .frames = {"123#FF"}, .first = 10ms});
    arrive("123#01");
    run_until(now - kStart + 10ms);
    EXPECT_EQ(told.take(), (Texts{"RX_CHANGED 123: 123#01", "RX_TIMEOUT 123:"}));

    arrive("123#01");

    EXPECT_EQ(told.take().size(), flag == 0 ? 0u : 1u);
  }
}

TEST_F(BroadcastReception, TellsTheLastContentOnceAThrottlingPeriod) {
  ask({.opcode = RX_SETUP, .id = "123", .flags = SETTIMER, .frames = {"123#FF"}, .second = 10ms});

  arrive("123#01");
  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#01"});
  run_until(4ms);
  arrive("123#02");
  arrive("123#03");
  EXPECT_EQ(told.take(), Texts{});
  run_until(10ms);
  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#03"});
  arrive("123#04");
  run_until(20ms);
  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#04"});
  run_until(30ms);

  EXPECT_EQ(manager.next_deadline(), kNever);  // a period without change ends the throttling
  arrive("123#05");
  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#05"});
}

TEST_F(BroadcastReception, DoesNotHoldBackContentThatChangesMoreSlowly) {
  ask({.opcode = RX_SETUP, .id = "123", .flags = SETTIMER, .frames = {"123#FF"}, .second = 10ms});
  arrive("123#01");
  told.take();
  run_until(10ms);

  arrive("123#02");

  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#02"});
}

TEST_F(BroadcastReception, HoldsBackEachMultiplexedContent) {
  ask({.opcode = RX_SETUP,
       .id = "123",
       .flags = SETTIMER,
       .frames = {"123#FF00", "123#01FF", "123#02FF"},
       .second = 10ms});
  arrive("123#0100");
  told.take();

  arrive("123#0101");
  arrive("123#0202");
  run_until(10ms);

  EXPECT_EQ(told.take(), (Texts{"RX_CHANGED 123: 123#0101", "RX_CHANGED 123: 123#0202"}));
}

TEST_F(BroadcastReception, TellsWhatItHeldBackWhenItsTimersAreSetAnew) {
  ask({.opcode = RX_SETUP, .id = "123", .flags = SETTIMER | RX_FILTER_ID, .second = 10ms});
  arrive("123#01");
  arrive("123#02");
  told.take();

  ask({.opcode = RX_SETUP, .id = "123", .flags = SETTIMER | RX_FILTER_ID});

  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#02"});
  EXPECT_EQ(manager.next_deadline(), kNever);
}

TEST_F(BroadcastReception, ForgetsContentWhenItsFiltersAreSetAnew) {
  const told::Asked filter{.opcode = RX_SETUP, .id = "123", .frames = {"123#FF"}};
  ask(filter);
  arrive("123#01");
  told.take();

  ask(filter);
  arrive("123#01");

  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#01"});
}

TEST_F(BroadcastReception, MayLoseFiltersButNotGainAny) {
  ask({.opcode = RX_SETUP, .id = "123", .frames = {"123#FF"}});

  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "123", .frames = {"123#FF", "123#FF"}}), E2BIG);
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "123", .flags = RX_FILTER_ID}), 0);
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "123", .frames = {"123#FF"}}), E2BIG);
}

TEST_F(BroadcastReception, AnswersARemoteFrame) {
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "705#R", .flags = RX_RTR_FRAME, .frames = {"705#7F"}}), 0);

  arrive("705#R");

  EXPECT_EQ(sent(), (Texts{"705#R", "705#7F"}));
  EXPECT_EQ(told.take(), Texts{});
}

TEST_F(BroadcastReception, DoesNotAnswerARemoteFrameWithItself) {
  ask({.opcode = RX_SETUP, .id = "705#R", .flags = RX_RTR_FRAME, .frames = {"705#R"}});
  ask({.opcode = RX_SETUP, .id = "706#R", .flags = RX_RTR_FRAME | TX_CP_CAN_ID, .frames = {"123#01"}});

  arrive("705#R");
  arrive("706#R");

  EXPECT_EQ(sent(), (Texts{"705#R", "705#", "706#R", "706#01"}));
}

TEST_F(BroadcastReception, AnswersRemoteFramesOnlyOnACertainInterface) {
  const auto answer =
      told::message({.opcode = RX_SETUP, .id = "705#R", .flags = RX_RTR_FRAME, .frames = {"705#7F"}});
  EXPECT_EQ(manager.request(answer, 0, now), 0);

  arrive("705#R");

  EXPECT_EQ(sent(), Texts{"705#R"});
}

TEST_F(BroadcastReception, RefusesAnAnswerThatIsNone) {
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "705", .flags = RX_RTR_FRAME, .frames = {"705#"}}), EINVAL);
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "705#R", .flags = RX_RTR_FRAME}), EINVAL);
  auto too_long = told::message({.opcode = RX_SETUP, .id = "705#R", .flags = RX_RTR_FRAME, .frames = {"705#"}});
  too_long[sizeof(bcm_msg_head) + offsetof(can_frame, can_dlc)] = std::byte{9};
  EXPECT_EQ(manager.request(too_long, kIndex, now), EINVAL);
  EXPECT_EQ(ask({.opcode = RX_SETUP, .id = "705#R", .flags = RX_RTR_FRAME, .frames = {"705#", "705#"}}), EINVAL);
}

TEST_F(BroadcastReception, HearsAllInterfacesWithTheIndexOfTheSender) {
  EXPECT_EQ(manager.request(told::message({.opcode = RX_SETUP, .id = "123"}), 0, now), 0);

  arrive("123#01");

  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#01"});
  EXPECT_EQ(told.interface_index, kIndex);
}

TEST_F(BroadcastReception, TellsFirstThatOfAllInterfacesAndOfOthersTheNewest) {
  ask({.opcode = RX_SETUP, .id = "123"});
  EXPECT_EQ(manager.request(told::message({.opcode = RX_SETUP, .id = "123", .frames = {"123#FF"}}), 0, now), 0);
  EXPECT_EQ(
      manager.request(told::message({.opcode = RX_SETUP, .id = "123", .flags = RX_CHECK_DLC}), kIndex + 1, now),
      0);

  arrive("123#01");

  EXPECT_EQ(told.flags, (std::vector<std::uint32_t>{0, RX_CHECK_DLC | RX_FILTER_ID, RX_FILTER_ID}));
}

TEST_F(BroadcastReception, HearsWhatItsOwnSocketSends) {
  ask({.opcode = RX_SETUP, .id = "123"});

  ask({.opcode = TX_SEND, .frames = {"123#01"}});

  EXPECT_EQ(told.take(), Texts{"RX_CHANGED 123: 123#01"});
}

TEST_F(BroadcastReception, DoesNotHearFramesThatAreNotLoopedBackNorErrorFrames) {
  ask({.opcode = RX_SETUP, .id = "123"});
  hub::Passage unheard = told::passage(other, "123#01");
  unheard.loopback = false;
  medium.send(unheard, now);
  unheard.loopback = true;
  unheard.frame.can_id |= CAN_ERR_FLAG;
  medium.send(unheard, now);

  EXPECT_EQ(told.take(), Texts{});
}

TEST_F(BroadcastReception, IsReadAndDeleted) {
  ask({.opcode = RX_SETUP, .id = "00000123", .flags = SETTIMER, .frames = {"00000123#FF"}, .first = 3s});

  EXPECT_EQ(ask({.opcode = RX_READ, .id = "00000123"}), 0);
  EXPECT_EQ(told.take(), Texts{"RX_STATUS 00000123: 00000123#FF"});
  EXPECT_EQ(told.last()->ival1.tv_sec, 3);
  EXPECT_EQ(ask({.opcode = RX_DELETE, .id = "00000123"}), 0);
  EXPECT_EQ(ask({.opcode = RX_DELETE, .id = "00000123"}), EINVAL);
  EXPECT_EQ(ask({.opcode = RX_READ, .id = "00000123"}), EINVAL);
  arrive("00000123#01");
  EXPECT_EQ(told.take(), Texts{});
}

}  // namespace
