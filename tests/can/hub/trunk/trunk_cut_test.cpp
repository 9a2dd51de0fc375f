#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "can/hub/trunk/trunk.hpp"
#include "tests/can/hub/trunk/several_hosts.hpp"

namespace {

using namespace std::chrono_literals;
using hub::trunk::Trunk;
using testing::Contains;
using testing::HasSubstr;
using Texts = std::vector<std::string>;
using TrunkCutTest = told::SeveralHosts;

TEST_F(TrunkCutTest, IsCutWhenNothingComesBackForHalfASecond) {
  join_all();
  server.is_stopped = true;
  a.send("123#01");
  a.turn();

  pass_time(Trunk::kPatience - 100ms);
  EXPECT_EQ(a.links, (std::vector{false, true}));
  pass_time(150ms);

  EXPECT_EQ(a.links, (std::vector{false, true, false}));
  EXPECT_EQ(a.trunk.figures().dropped, 1U);
  EXPECT_EQ(a.trunk.figures().cuts, 1U);
  EXPECT_THAT(a.notices, Contains(HasSubstr("cut: nothing has come back for 500 ms; 1 frames were under way")));
}

TEST_F(TrunkCutTest, SendsNothingLateAfterTheServerStoodStill) {
  join_all();
  server.is_stopped = true;
  for (int i = 0; i < 40; ++i) {
    a.send("123#01");
    pass_time(20ms);  // in the middle of it the wire is cut
  }
  const std::uint64_t lost = a.trunk.figures().dropped + a.medium.lost();
  EXPECT_EQ(lost, 40U);

  server.is_stopped = false;
  join_all();
  a.send("124#02");
  turn_all();

  EXPECT_EQ(a.member.seen, Texts{"124#02"});
  EXPECT_EQ(b.member.seen, Texts{"124#02"});
  EXPECT_EQ(a.trunk.figures().dropped + a.medium.lost(), 40U);
}

TEST_F(TrunkCutTest, NobodyLetsPassWhatReachesTheStreamTooLate) {
  join_all();
  server.is_stopped = true;
  a.send("123#01");
  a.turn();
  const auto late = a.line.asked;
  a.line.asked.clear();
  server.is_stopped = false;

  hosts = {&b};
  pass_time(Trunk::kPatience + 1ms);
  server.put(late.front());
  b.turn();

  EXPECT_EQ(b.member.seen, Texts{});
  EXPECT_EQ(b.trunk.figures().stale, 1U);
}

TEST_F(TrunkCutTest, NobodyLetsPassWhatComesBehindTheReturnOfItsHub) {
  join_all();
  server.is_stopped = true;
  a.send("123#01");
  a.turn();
  a.line.is_lost = true;  // and the server has the message still
  a.turn();
  EXPECT_EQ(a.trunk.figures().dropped, 1U);

  server.is_stopped = false;
  server.now += 20ms;
  const auto asked = std::exchange(a.line.asked, {});
  a.open();
  turn_all();
  server.put(asked.front());
  turn_all();

  EXPECT_EQ(a.member.seen, Texts{});
  EXPECT_EQ(b.member.seen, Texts{});
  EXPECT_EQ(a.trunk.figures().dropped, 1U);
  EXPECT_EQ(b.trunk.hubs().missed(), 1U);
}

TEST_F(TrunkCutTest, CountsAsDroppedWhatPassesForOthersAlone) {
  join_all();
  server.is_stopped = true;
  a.send("123#01");
  a.turn();
  a.line.is_lost = true;
  a.turn();
  const auto asked = std::exchange(a.line.asked, {});

  a.open();  // its beat is on its way, behind the frame
  server.put(asked.front());
  server.is_stopped = false;
  turn_all();

  EXPECT_EQ(b.member.seen, Texts{"123#01"});
  EXPECT_EQ(a.member.seen, Texts{});
  EXPECT_EQ(a.trunk.figures().dropped, 1U);
  EXPECT_EQ(a.trunk.figures().sent, 0U);
}

TEST_F(TrunkCutTest, IsCutWhenOnlyItsOwnMessagesDoNotComeBack) {
  join_all();
  a.line.is_held = true;
  a.send("123#01");

  pass_time(Trunk::kPatience + 150ms);  // b is heard all the time

  EXPECT_EQ(a.links, (std::vector{false, true, false}));
  EXPECT_EQ(a.trunk.figures().dropped, 1U);
  EXPECT_EQ(b.links, (std::vector{false, true}));
}

TEST_F(TrunkCutTest, SaysOnceThatNothingComesBackFromAServerThatIsFull) {
  a.line.is_held = true;
  for (int i = 0; i < 5; ++i) {
    a.open();
    pass_time(Trunk::kPatience + 100ms);
  }

  EXPECT_EQ(a.line.opened, 5U);
  EXPECT_EQ(a.notices,
            Texts{"nats://told/bus: nothing that this hub sends comes back: the server is full, or does "
                  "not let it publish"});
}

TEST_F(TrunkCutTest, CountsWhatItHasMissedOfOthers) {
  join_all();
  b.line.is_lost = true;
  b.turn();
  for (int i = 0; i < 7; ++i) a.send("123#01");
  pass_time(100ms);
  EXPECT_EQ(b.trunk.hubs().missed(), 0U);

  b.open();
  pass_time(200ms);

  EXPECT_EQ(b.trunk.hubs().missed(), 7U);
  EXPECT_EQ(b.member.seen, Texts{});
  EXPECT_EQ(b.links, (std::vector{false, true, false, true}));
  EXPECT_THAT(a.notices, Contains(HasSubstr("b is on the bus again")));
}

TEST_F(TrunkCutTest, IsCutWhenAMessageIsMissing) {
  join_all();
  server.skip();
  a.send("123#01");
  turn_all();

  EXPECT_EQ(a.trunk.figures().cuts, 1U);
  EXPECT_EQ(b.trunk.figures().cuts, 1U);
  EXPECT_THAT(b.notices, Contains(HasSubstr("cut: the stream went from message")));
  EXPECT_EQ(b.member.seen, Texts{});
}

TEST_F(TrunkCutTest, IsCutWhenItStoodStillItself) {
  join_all();
  server.now += 14s;  // b runs, a does not
  for (int i = 0; i < 4; ++i) b.turn();
  b.line.given.clear();

  a.send("123#01");

  EXPECT_FALSE(a.trunk.is_up());
  EXPECT_EQ(a.trunk.figures().dropped, 1U);
  EXPECT_THAT(a.notices, Contains(HasSubstr("cut: this hub was kept from running")));
  a.turn();
  EXPECT_TRUE(a.line.asked.empty());

  join_all();
  EXPECT_EQ(b.trunk.hubs().missed(), 1U);
}

}  // namespace
