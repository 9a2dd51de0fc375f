#include "can/hub/trunk/arbitration.hpp"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "can/hub/medium/bit_time.hpp"
#include "tests/can/hub/trunk/hosts_with_rate.hpp"

namespace {

using namespace std::chrono_literals;
using hub::trunk::Trunk;
using testing::Contains;
using testing::HasSubstr;
using told::Host;
using ArbitrationTest = told::HostsWithRate;

TEST_F(ArbitrationTest, MakesOneOfTheHubsTheArbiter) {
  join_all();

  EXPECT_EQ(std::ranges::count_if(hosts, [](const Host* host) { return host->is_arbiter(); }), 1);
  for (const Host* const host : hosts) {
    EXPECT_EQ(host->links, (std::vector{false, true}));
    EXPECT_EQ(host->trunk.arbitration()->arbiter(), arbiter().medium.number_of_hub());
    EXPECT_EQ(host->line.listens, host->is_arbiter());
  }
  EXPECT_THAT(arbiter().notices, Contains(HasSubstr("this hub is the arbiter")));
  const auto report = nlohmann::json::parse(other().trunk.report(8192)).at("arbitration");
  EXPECT_EQ(report.at("bit_rate"), kRate);
  EXPECT_EQ(report.at("arbiter"), arbiter().trunk.settings().name);
  EXPECT_EQ(report.at("is_here"), false);
  const auto own = nlohmann::json::parse(arbiter().trunk.report(8192)).at("arbitration");
  EXPECT_EQ(own.at("arbiter"), arbiter().trunk.settings().name);
  EXPECT_EQ(own.at("is_here"), true);
}

TEST_F(ArbitrationTest, IsJoinedAtOnceWhereThereIsAnArbiter) {
  join_all();
  Host d{server, "d", kRate};
  hosts.push_back(&d);

  d.open();
  turn_all();

  EXPECT_TRUE(d.trunk.is_up());
}

TEST_F(ArbitrationTest, LetsTheLowestIdentifierOfAllHostsPass) {
  join_all();
  a.send("7FF#");
  turn_all();  // has the bus to itself
  told::Listener another;
  b.medium.attach(another);
  a.send("300#");
  b.send("200#");
  b.send("100#");  // behind 200h in its controller
  b.send(another, "150#");
  c.send("048C0000#");
  turn_all();

  pass_time(60ms);

  for (const Host* const host : hosts)
    EXPECT_EQ(host->member.seen, (Texts{"7FF#", "048C0000#", "150#", "200#", "100#", "300#"}));
  EXPECT_EQ(another.passages[2].sender, &another);
  EXPECT_EQ(b.member.passages[3].sender, &b.member);
  EXPECT_EQ(c.member.passages[3].sender, nullptr);
  b.medium.detach(another);
}

TEST_F(ArbitrationTest, GivesAllHostsTheSameTimesWhichAreThoseOfTheBits) {
  join_all();
  const Texts frames{"100#", "200#0102030405060708", "00000300#R", "400#FFFFFFFF"};
  for (const std::string& frame : frames) a.send(frame);
  turn_all();

  pass_time(60ms);

  ASSERT_EQ(c.member.seen, frames);
  for (std::size_t i = 0; i < frames.size(); ++i)
    EXPECT_EQ(c.member.passages[i].time_ns, a.member.passages[i].time_ns);
  for (std::size_t i = 1; i < frames.size(); ++i)
    EXPECT_EQ(a.member.passages[i].time_ns - a.member.passages[i - 1].time_ns,
              std::chrono::nanoseconds{hub::bits_on_wire(told::wire(frames[i])) * kBit}.count());
}

TEST_F(ArbitrationTest, LetsNoFramePassBeforeItsTime) {
  join_all();
  const canopen::Duration time = hub::bits_on_wire(told::wire("123#01")) * kBit;
  other().send("123#01");
  turn_all();

  server.now += time - 1ns;
  turn_all();
  EXPECT_EQ(a.member.seen, Texts{});
  server.now += 1ns;
  turn_all();
  EXPECT_EQ(a.member.seen, Texts{"123#01"});
}

TEST_F(ArbitrationTest, ShowsAllHostsOneOrderAndCountsAll) {
  const unsigned seed = told::seed();
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  join_all();
  std::uint64_t refused = 0;

  for (int i = 0; i < 3000; ++i) {
    Host& host = *hosts[random() % hosts.size()];
    if (!host.medium.send(told::passage(host.member, fmt::format("{:03X}#{:08X}", random() % 0x800, i)),
                          server.now))
      ++refused;
    if (random() % 3 == 0) pass_time(1ms, 1ms);
  }
  pass_time(1s);

  EXPECT_EQ(a.member.seen.size(), 3000 - refused);
  EXPECT_EQ(b.member.seen, a.member.seen);
  EXPECT_EQ(c.member.seen, a.member.seen);
  EXPECT_TRUE(std::ranges::is_sorted(a.member.passages, {}, &hub::Passage::time_ns));
  for (const Host* const host : hosts) {
    EXPECT_EQ(host->trunk.figures().sent + host->trunk.figures().received, 3000 - refused);
    EXPECT_EQ(host->trunk.hubs().missed(), 0U);
    EXPECT_EQ(host->trunk.figures().cuts, 0U);
  }
}

TEST_F(ArbitrationTest, TakesAFewFramesOfAMemberAtATime) {
  join_all();
  std::size_t taken = 0;
  while (a.medium.send(told::passage(a.member, "7FF#"), server.now)) ++taken;
  EXPECT_EQ(taken, 2 * hub::kMostWaiting);

  told::Listener urgent;
  a.medium.attach(urgent);
  a.send(urgent, "001#");
  pass_time(100ms);

  EXPECT_EQ(b.member.seen.size(), taken + 1);
  EXPECT_THAT((Texts{b.member.seen[0], b.member.seen[1]}), Contains("001#"));
  EXPECT_EQ(a.member.rooms, 1U);
  a.medium.detach(urgent);
}

TEST_F(ArbitrationTest, PassesWhatAMemberHasSentThatHasLeft) {
  join_all();
  told::Listener leaving;
  a.medium.attach(leaving);
  for (std::size_t i = 0; i < 2 * hub::kMostWaiting; ++i) a.send(leaving, "123#");
  a.medium.detach(leaving);

  pass_time(100ms);

  EXPECT_EQ(b.member.seen.size(), 2 * hub::kMostWaiting);
  EXPECT_EQ(a.member.passages.back().sender, nullptr);
}

TEST_F(ArbitrationTest, CountsRequestsThatAreNone) {
  join_all();
  server.request({std::byte{1}, std::byte{2}});
  server.request(std::vector<std::byte>(100, std::byte{1}));
  turn_all();

  EXPECT_EQ(arbiter().trunk.arbitration()->malformed(), 2U);
  EXPECT_THAT(arbiter().notices, Contains(HasSubstr("request is too short for a message of a hub")));
  EXPECT_EQ(nlohmann::json::parse(arbiter().trunk.report(8192)).at("malformed"), 2);
  other().send("123#01");
  pass_time(60ms);
  EXPECT_EQ(a.member.seen, Texts{"123#01"});
}

TEST_F(ArbitrationTest, CutsAHubOfWhichARequestIsLost) {
  join_all();
  Host& host = other();
  server.is_stopped = true;
  host.send("123#01");
  host.turn();
  host.line.requested.clear();  // it gets lost on its way
  server.is_stopped = false;
  host.send("124#01");
  turn_all();

  EXPECT_EQ(host.trunk.figures().cuts, 1U);
  EXPECT_EQ(host.trunk.figures().dropped, 2U);
  EXPECT_THAT(host.notices, Contains(HasSubstr("cut: the arbiter has lost frames of this hub; 2 frames")));
  EXPECT_TRUE(host.trunk.is_up());  // again
  EXPECT_EQ(arbiter().trunk.figures().cuts, 0U);
  host.send("125#01");
  pass_time(60ms);
  EXPECT_EQ(a.member.seen, Texts{"125#01"});
}

TEST_F(ArbitrationTest, CountsWhatAHubHasMissedOfEachOther) {
  join_all();
  a.send("100#");
  b.send("101#");
  pass_time(60ms);
  c.line.is_lost = true;
  c.turn();
  stop(c);
  for (int i = 0; i < 7; ++i) a.send("123#01");
  for (int i = 0; i < 5; ++i) b.send("122#01");
  pass_time(100ms);
  EXPECT_EQ(c.trunk.hubs().missed(), 0U);

  go_on(c);
  pass_time(200ms);

  EXPECT_EQ(a.member.seen.size(), 14U);
  EXPECT_EQ(c.trunk.hubs().missed(), 12U);
  EXPECT_EQ(c.member.seen.size(), 2U);
}

}  // namespace
