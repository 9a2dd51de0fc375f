#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "can/hub/trunk/trunk.hpp"
#include "tests/can/hub/trunk/hosts_with_rate.hpp"

namespace {

using namespace std::chrono_literals;
using hub::trunk::Trunk;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using told::Host;
using ArbiterGoneTest = told::HostsWithRate;

TEST_F(ArbiterGoneTest, AnotherHubTakesItsPlace) {
  join_all();
  Host& gone = arbiter();
  Host& host = other();
  for (int i = 0; i < 5; ++i) host.send("123#01");
  host.turn();

  stop(gone);
  pass_time(Trunk::kPatience - 60ms);
  EXPECT_TRUE(host.trunk.is_up());
  pass_time(200ms);

  for (const Host* const each : hosts) {
    EXPECT_EQ(each->links, (std::vector{false, true, false, true}));
    EXPECT_THAT(each->notices, Contains(HasSubstr("cut: no arbiter has been heard for 500 ms")));
    EXPECT_THAT(each->notices, Contains(HasSubstr("joined again")));
  }
  EXPECT_EQ(host.trunk.figures().dropped, 5U);
  host.send("124#02");
  pass_time(60ms);
  for (const Host* const each : hosts) EXPECT_EQ(each->member.seen, Texts{"124#02"});
}

TEST_F(ArbiterGoneTest, NothingComesLateOrTwiceWhenItReturns) {
  join_all();
  Host& gone = arbiter();
  Host& host = other();
  for (int i = 0; i < 5; ++i) host.send("123#01");
  host.turn();
  gone.send("122#01");
  stop(gone);
  pass_time(3s);
  host.send("124#02");
  pass_time(60ms);

  go_on(gone);
  pass_time(1s);

  EXPECT_FALSE(gone.is_arbiter());
  EXPECT_TRUE(gone.trunk.is_up());
  EXPECT_EQ(gone.trunk.figures().dropped, 1U);
  for (const Host* const each : hosts) {
    EXPECT_EQ(each->member.seen, each == &gone ? Texts{} : Texts{"124#02"});
    EXPECT_EQ(each->trunk.figures().cuts, 1U);
  }
  gone.send("125#03");
  pass_time(60ms);
  for (const Host* const each : hosts) EXPECT_THAT(each->member.seen, Contains("125#03"));
}

TEST_F(ArbiterGoneTest, IsNotObeyedWhenItsMessagesComeBehindAnother) {
  join_all();
  Host& gone = arbiter();
  Host& host = other();
  host.send("123#01");
  host.turn();
  gone.trunk.on_readable(server.now);  // has it on the bus
  server.now += 2ms;
  server.is_stopped = true;
  gone.trunk.on_time(server.now);  // lets it pass: in a message that is held up
  const auto late = std::exchange(gone.line.asked, {});
  ASSERT_FALSE(late.empty());
  server.is_stopped = false;
  stop(gone);
  pass_time(1s);
  const std::uint64_t before = host.trunk.figures().stale;

  for (const auto& message : late) server.put(message);
  turn_all();

  EXPECT_GT(host.trunk.figures().stale, before);
  for (const Host* const each : hosts) {
    EXPECT_EQ(each->member.seen, Texts{});
    EXPECT_TRUE(each->trunk.is_up());
    EXPECT_EQ(each->trunk.figures().cuts, 1U);
  }
  EXPECT_EQ(host.trunk.figures().dropped, 1U);
}

TEST_F(ArbiterGoneTest, ItsTermIsOverForAllWithAMessageThatIsLate) {
  join_all();
  Host& slow = arbiter();
  Host& host = other();
  const auto term = host.trunk.arbitration()->term();
  host.send("123#01");
  host.turn();
  slow.trunk.on_readable(server.now);
  server.is_stopped = true;
  for (int i = 0; i < 11; ++i) {  // it runs, and its messages are held up
    server.now += 45ms;
    slow.trunk.on_time(server.now);
  }
  for (Host* const each : hosts) each->trunk.on_readable(server.now);
  const auto late = std::exchange(slow.line.asked, {});
  for (Host* const each : hosts) each->line.asked.clear();
  server.now += 6ms;
  server.is_stopped = false;

  server.put(late.back());
  turn_all();

  for (const Host* const each : hosts) {
    EXPECT_EQ(each->member.seen, Texts{});
    EXPECT_THAT(each->notices, Contains(HasSubstr("cut: the arbiter was cut itself")));
  }
  pass_time(800ms);
  for (const Host* const each : hosts) {
    EXPECT_TRUE(each->trunk.is_up());
    EXPECT_GT(each->trunk.arbitration()->term(), term);
  }
}

TEST_F(ArbiterGoneTest, NobodyIsCutByAHubThatIsNot) {
  join_all();
  Host& gone = other();
  for (int i = 0; i < 5; ++i) gone.send("123#01");
  gone.turn();
  stop(gone);

  pass_time(3s);

  for (const Host* const each : hosts) EXPECT_EQ(each->trunk.figures().cuts, 0U);
  EXPECT_EQ(a.member.seen.size(), 5U);  // they had been asked for
}

TEST_F(ArbiterGoneTest, WhatAHubThatIsGoneHasAskedForIsNotLetPassLate) {
  join_all();
  Host& gone = other();
  Host& busy = arbiter();
  const auto fill = [&] {
    for (std::size_t i = 0; i < hub::kMostWaiting; ++i) busy.send("001#0102030405060708");
  };
  fill();
  turn_all();
  gone.send("7FF#01");
  gone.turn();
  stop(gone);

  for (canopen::Duration time{}; time < 1s; time += 5ms) {  // the bus is never idle
    fill();
    pass_time(5ms, 5ms);
  }
  pass_time(200ms);
  EXPECT_THAT(busy.member.seen, Not(Contains("7FF#01")));

  go_on(gone);
  pass_time(500ms);
  EXPECT_EQ(gone.trunk.figures().dropped, 1U);
  EXPECT_TRUE(gone.trunk.is_up());
  EXPECT_THAT(busy.member.seen, Not(Contains("7FF#01")));
}

TEST_F(ArbiterGoneTest, AllGoOnWhenTheServerStoodStill) {
  join_all();
  other().send("123#01");
  server.is_stopped = true;
  pass_time(3s);
  server.is_stopped = false;
  pass_time(1s);

  other().send("124#02");
  pass_time(60ms);

  for (const Host* const each : hosts) {
    EXPECT_EQ(each->member.seen, Texts{"124#02"});
    EXPECT_TRUE(each->trunk.is_up());
  }
}

}  // namespace
