#include <gtest/gtest.h>

#include "farm/agent/plan/plan.hpp"

namespace farm::agent {
namespace {

using namespace std::chrono_literals;

/// An agent of host a, whose unit line1/5 and hub with 500 kbit/s run since before it.
class HubsOfPlan : public testing::Test {
 protected:
  HubsOfPlan() {
    plan.on_found({{"line1", "5"}, "{}", 1, "g"}, now);
    plan.hubs().on_found("line1", 500'000, now);
    plan.on_up(now);
  }
  void tell_bit_rate(int rate) {
    plan.on_entry(Bucket::Buses, {"line1", "{\"bitrate\":" + std::to_string(rate) + "}", ++revision});
  }
  void tell_all() {
    plan.on_entry(Bucket::Units, {"line1.5", R"({"configuration":{}})", ++revision});
    plan.on_entry(Bucket::Units, {"generation", "g", ++revision});
    for (const Bucket bucket : {Bucket::Units, Bucket::Places, Bucket::Buses, Bucket::Hosts})
      plan.on_all(bucket, now);
  }

  canopen::TimePoint now{1h};
  std::uint64_t revision = 0;
  Plan plan{Self{.host = "a", .instance = 7}, now};
};

TEST_F(HubsOfPlan, AreLeftAloneUntilAllIsTold) {
  EXPECT_TRUE(plan.advance(now).hub_stops.empty());
  tell_bit_rate(500'000);
  tell_all();
  EXPECT_TRUE(plan.advance(now).hub_stops.empty());
}

TEST_F(HubsOfPlan, AreStartedAgainWithAnotherBitRate) {
  tell_bit_rate(250'000);
  tell_all();
  EXPECT_EQ(plan.advance(now).hub_stops, std::vector<std::string>{"line1"});
  plan.hubs().on_ended("line1", "canhub has ended", now);

  const Orders orders = plan.advance(now);
  ASSERT_EQ(orders.hub_starts.size(), 1u);
  EXPECT_EQ(orders.hub_starts.front().bit_rate, 250'000u);
}

}  // namespace
}  // namespace farm::agent
