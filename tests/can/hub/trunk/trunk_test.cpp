#include "can/hub/trunk/trunk.hpp"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/can/hub/trunk/several_hosts.hpp"

namespace {

using namespace std::chrono_literals;
using hub::trunk::Trunk;
using testing::Contains;
using testing::HasSubstr;
using Texts = std::vector<std::string>;
using TrunkTest = told::SeveralHosts;

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
  EXPECT_EQ(b.trunk.figures().received, 0U);
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
  turn_all();
  server.now += Trunk::kPatience;
  server.put(message);  // by now it is late as well
  turn_all();

  EXPECT_EQ(b.member.seen, Texts{"123#01"});
  EXPECT_EQ(b.trunk.hubs().repeated(), 2U);
  EXPECT_EQ(a.member.seen, Texts{"123#01"});
  EXPECT_EQ(a.trunk.figures().repeated, 2U);
  EXPECT_TRUE(a.trunk.is_up());
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
