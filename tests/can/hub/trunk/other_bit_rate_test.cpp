#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "can/hub/faults/faults.hpp"
#include "can/hub/trunk/trunk.hpp"
#include "tests/can/hub/trunk/hosts_with_rate.hpp"

namespace {

using namespace std::chrono_literals;
using hub::trunk::Trunk;
using testing::Contains;
using testing::HasSubstr;
using told::Host;
using OtherBitRateTest = told::HostsWithRate;

TEST_F(OtherBitRateTest, AHubThatComesLaterDoesNotJoin) {
  join_all();
  Host d{server, "d", 500'000};
  hosts.push_back(&d);
  d.open();
  pass_time(5s);

  EXPECT_EQ(d.links, (std::vector{false}));
  ASSERT_EQ(d.notices.size(), 1U);
  EXPECT_THAT(d.notices[0],
              testing::EndsWith("has the bus at 125000 bit/s, this hub is to have it at 500000 bit/s"));
  EXPECT_THAT(d.notices[0], HasSubstr("not joined"));
  for (const Host* const each : {&a, &b, &c}) {
    EXPECT_EQ(each->trunk.figures().cuts, 0U);
    EXPECT_EQ(each->links, (std::vector{false, true}));
  }
}

TEST_F(OtherBitRateTest, AHubWithoutOneDoesNotJoinEither) {
  join_all();
  Host d{server, "d"};
  hosts.push_back(&d);
  d.open();
  d.send("123#01");
  pass_time(5s);

  EXPECT_FALSE(d.trunk.is_up());
  EXPECT_THAT(d.notices,
              Contains(HasSubstr("has the bus at 125000 bit/s, this hub is to have it without a bit rate")));
  for (const Host* const each : {&a, &b, &c}) {
    EXPECT_EQ(each->member.seen, Texts{});
    EXPECT_EQ(each->trunk.figures().cuts, 0U);
  }
}

TEST_F(OtherBitRateTest, AHubWithOneDoesNotJoinThoseWithout) {
  Host d{server, "d"};
  Host e{server, "e"};
  hosts = {&d, &e};
  join_all();
  hosts.push_back(&a);
  a.open();
  pass_time(5s);
  d.send("123#01");
  pass_time(60ms);

  EXPECT_FALSE(a.trunk.is_up());
  ASSERT_EQ(a.notices.size(), 1U);
  EXPECT_THAT(a.notices[0], HasSubstr("has the bus without a bit rate, this hub is to have it at 125000 bit/s"));
  EXPECT_EQ(e.member.seen, Texts{"123#01"});
  EXPECT_EQ(d.links, (std::vector{false, true}));
}

TEST_F(OtherBitRateTest, ItJoinsWhenTheOthersHaveLeft) {
  Host d{server, "d", 500'000};
  join_all();
  hosts.push_back(&d);
  d.open();
  pass_time(1s);

  hosts = {&d};
  pass_time(3s);

  EXPECT_TRUE(d.trunk.is_up());
  EXPECT_TRUE(d.is_arbiter());
}

TEST_F(OtherBitRateTest, OneOfTwoThatComeTogetherJoins) {
  Host d{server, "d", 500'000};
  hosts = {&a, &d};
  for (Host* const host : hosts) host->open();

  pass_time(3s);

  EXPECT_NE(a.trunk.is_up(), d.trunk.is_up());
}

TEST_F(OtherBitRateTest, IsNoFaultOfABusOverSeveralHosts) {
  hub::Interfaces interfaces;
  hub::faults::Faults faults{a.medium, interfaces};

  const auto number = faults.inject("bus.bit-rate bit_rate=250000", server.now);

  ASSERT_FALSE(number);
  EXPECT_EQ(number.error(), "expected a bus of one host for another bit rate, got one over several");
}

}  // namespace
