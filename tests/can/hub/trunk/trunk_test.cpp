#include "can/hub/trunk/trunk.hpp"

#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/can/hub/trunk/told_stream.hpp"

namespace {

using namespace std::chrono_literals;
using hub::trunk::Trunk;
using testing::Contains;
using testing::HasSubstr;
using Texts = std::vector<std::string>;

class TrunkTest : public testing::Test {
 protected:
  /// Both have joined and know each other.
  void join_all() {
    for (told::Host* const host : hosts) host->open();
    pass_time(150ms);
  }
  /// Nothing waits any more behind it.
  void turn_all() {
    for (int i = 0; i < 4; ++i)
      for (told::Host* const host : hosts) host->turn();
  }
  /// Time goes on, as it does for hubs that run.
  void pass_time(canopen::Duration time) {
    for (const canopen::TimePoint end = server.now + time; server.now < end; turn_all())
      server.now += std::min<canopen::Duration>(50ms, end - server.now);
  }

  told::Server server;
  told::Host a{server, "a"};
  told::Host b{server, "b"};
  std::vector<told::Host*> hosts{&a, &b};
};

TEST_F(TrunkTest, LetsAFramePassWhenItComesBack) {
  join_all();
  server.is_stopped = true;

  a.send("123#0102");
  a.turn();
  EXPECT_EQ(a.member.seen, Texts{});

  server.is_stopped = false;
  turn_all();
  EXPECT_EQ(a.member.seen, Texts{"123#0102"});
  EXPECT_EQ(b.member.seen, Texts{"123#0102"});
  EXPECT_EQ(a.member.passages[0].sender, &a.member);
  EXPECT_TRUE(a.member.passages[0].local);
  EXPECT_EQ(b.member.passages[0].sender, nullptr);
  EXPECT_FALSE(b.member.passages[0].local);
  EXPECT_EQ(a.member.passages[0].time_ns, b.member.passages[0].time_ns);
}

TEST_F(TrunkTest, ShowsAllHostsOneOrder) {
  const unsigned seed = told::seed();
  RecordProperty("seed", static_cast<int>(seed));
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  told::Host c{server, "c"};
  hosts.push_back(&c);
  join_all();

  for (int i = 0; i < 3000; ++i) {
    told::Host& host = *hosts[random() % hosts.size()];
    if (random() % 3 == 0) host.turn();
    host.send(fmt::format("{:03X}#{:08X}", random() % 0x800, i));
  }
  turn_all();

  EXPECT_EQ(a.member.seen.size(), 3000U);
  EXPECT_EQ(b.member.seen, a.member.seen);
  EXPECT_EQ(c.member.seen, a.member.seen);
  EXPECT_EQ(a.trunk.figures().sent + b.trunk.figures().sent + c.trunk.figures().sent, 3000U);
}

TEST_F(TrunkTest, KeepsErrorFramesOnTheirHost) {
  join_all();

  hub::Passage error = told::passage(a.member, "004#0001000000000000");
  error.frame.can_id |= CAN_ERR_FLAG;
  a.medium.send(error, server.now);
  turn_all();

  EXPECT_EQ(a.member.seen.size(), 1U);
  EXPECT_EQ(b.member.seen, Texts{});
}

TEST_F(TrunkTest, IsFullWhenTooManyFramesAreUnderWay) {
  join_all();
  server.is_stopped = true;
  std::size_t taken = 0;

  while (a.medium.send(told::passage(a.member, "123#"), server.now)) ++taken;

  EXPECT_EQ(taken, Trunk::kMostUnderWay + hub::Medium::kQueue);
  server.is_stopped = false;
  turn_all();
  EXPECT_EQ(a.member.rooms, 1U);
  EXPECT_EQ(b.member.seen.size(), taken);
}

TEST_F(TrunkTest, IsCutWhenNothingComesBackForHalfASecond) {
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
  EXPECT_THAT(a.notices, Contains(HasSubstr("cut: nothing has come for 500 ms; 1 frames were under way")));
}

TEST_F(TrunkTest, SendsNothingLateAfterTheServerStoodStill) {
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

TEST_F(TrunkTest, NobodyLetsPassWhatReachesTheStreamTooLate) {
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

TEST_F(TrunkTest, NobodyLetsPassWhatComesBehindTheReturnOfItsHub) {
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

TEST_F(TrunkTest, CountsAsSentWhatHasPassedForOthersAfterTheCut) {
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
  EXPECT_EQ(a.trunk.figures().dropped, 0U);
  EXPECT_EQ(a.trunk.figures().sent, 1U);
}

TEST_F(TrunkTest, CountsWhatItHasMissedOfOthers) {
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

TEST_F(TrunkTest, IsCutWhenAMessageIsMissing) {
  join_all();
  server.skip();
  a.send("123#01");
  turn_all();

  EXPECT_EQ(a.trunk.figures().cuts, 1U);
  EXPECT_EQ(b.trunk.figures().cuts, 1U);
  EXPECT_THAT(b.notices, Contains(HasSubstr("cut: the stream went from message")));
  EXPECT_EQ(b.member.seen, Texts{});
}

TEST_F(TrunkTest, IsCutWhenItStoodStillItself) {
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
}

TEST_F(TrunkTest, CountsMessagesThatAreNone) {
  join_all();
  server.put({std::byte{1}, std::byte{2}});
  server.put(std::vector<std::byte>(100, std::byte{1}));
  turn_all();

  EXPECT_EQ(a.trunk.figures().malformed, 2U);
  EXPECT_TRUE(a.trunk.is_up());
  EXPECT_THAT(a.notices, Contains(HasSubstr("is too short for a message of a hub")));
}

TEST_F(TrunkTest, GivesAFrameNoSecondTime) {
  join_all();
  server.is_stopped = true;
  a.send("123#01");
  a.turn();
  server.is_stopped = false;
  const auto message = a.line.asked.front();
  turn_all();

  server.put(message);
  b.turn();

  EXPECT_EQ(b.member.seen, Texts{"123#01"});
  EXPECT_EQ(b.trunk.hubs().repeated(), 1U);
}

TEST_F(TrunkTest, TellsWhoHasLeft) {
  join_all();
  hosts = {&a};

  pass_time(1200ms);

  EXPECT_THAT(a.notices, Contains(HasSubstr("b is on the bus no more")));
}

TEST_F(TrunkTest, PassesWithoutASenderThatHasLeft) {
  join_all();
  server.is_stopped = true;
  told::Listener other;
  a.medium.attach(other);
  a.medium.send(told::passage(other, "123#01"), server.now);
  a.turn();

  a.medium.detach(other);
  server.is_stopped = false;
  turn_all();

  EXPECT_EQ(a.member.seen, Texts{"123#01"});
  EXPECT_EQ(a.member.passages[0].sender, nullptr);
}

}  // namespace
