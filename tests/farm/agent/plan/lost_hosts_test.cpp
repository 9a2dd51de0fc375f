#include <gtest/gtest.h>

#include "tests/farm/agent/plan/plan_fixture.hpp"

namespace farm::agent {
namespace {

using namespace std::chrono_literals;
using told::at;
using told::Host;
using told::kUnit;
using told::unit;

using LostHosts = told::PlanTest;

TEST_F(LostHosts, RunsTheUnitsOfALostHostElsewhereWithinFiveSeconds) {
  for (const char* const name : {"a", "b", "c"}) farm.add(name);
  want_many(90);
  ASSERT_TRUE(farm.pass_until([&] { return all_run(90); }));
  farm.hosts.front().kill();

  EXPECT_TRUE(farm.pass_until([&] { return all_run(90); }, 5s));
  EXPECT_NEAR(static_cast<double>(farm.hosts.back().units.size()), 45, 2);
}

TEST_F(LostHosts, StartsAUnitElsewhereWithWhatItHasSaved) {
  Host& a = farm.add("a");
  farm.want(kUnit);
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  a.save(kUnit);
  farm.pass(1s);
  const int value = a.units.at(kUnit).value;
  Host& b = farm.add("b");
  farm.pass(1s);
  a.kill();

  ASSERT_TRUE(farm.pass_until([&] { return b.runs(kUnit); }));
  EXPECT_EQ(b.units.at(kUnit).value, value);
}

TEST_F(LostHosts, LeavesUnitsToAHostWhoseAgentAloneIsDead) {
  Host& a = farm.add("a");
  Host& b = farm.add("b");
  farm.want(kUnit, at("a"));
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  farm.want(kUnit);
  a.kill_agent();
  farm.pass(20s);
  EXPECT_TRUE(a.runs(kUnit));
  EXPECT_FALSE(b.runs(kUnit));

  a.start_agent();
  farm.pass(20s);
  EXPECT_TRUE(a.runs(kUnit));
  EXPECT_EQ(a.starts, 1u);
  EXPECT_EQ(farm.place(kUnit).instance, a.instance);
}

TEST_F(LostHosts, TakesAUnitThatHasEndedOnAHostWithoutAgent) {
  Host& a = farm.add("a");
  Host& b = farm.add("b");
  farm.want(kUnit, at("a"));
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  farm.want(kUnit);
  farm.pass(1s);
  a.kill_agent();
  farm.pass(5s);
  a.kill_unit(kUnit);

  EXPECT_TRUE(farm.pass_until([&] { return b.runs(kUnit); }, 5s));
}

TEST_F(LostHosts, StopsItsUnitsWithoutContactAndStartsThoseThatAreItsOwnAfterwards) {
  Host& a = farm.add("a");
  farm.want(kUnit);
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  a.cut();
  farm.pass(1500ms);
  EXPECT_TRUE(a.runs(kUnit));
  farm.pass(1s);
  EXPECT_TRUE(a.units.empty());
  EXPECT_EQ(told(a, "no sign of the server"), 1u);

  a.heal();
  EXPECT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }, 3s));
  EXPECT_EQ(farm.place(kUnit).term, 1u);
}

TEST_F(LostHosts, KeepsItsUnitsThroughAShortCut) {
  Host& a = farm.add("a");
  farm.want(kUnit);
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  a.cut();
  farm.pass(1300ms);
  a.heal();
  farm.pass(10s);

  EXPECT_TRUE(a.runs(kUnit));
  EXPECT_EQ(a.starts, 1u);
}

TEST_F(LostHosts, StopsAUnitThatOthersHaveTakenMeanwhile) {
  Host& a = farm.add("a");
  Host& b = farm.add("b");
  farm.want(kUnit, R"({"configuration":{},"host":["a","b"]})");
  ASSERT_TRUE(farm.pass_until([&] { return farm.runs_once(kUnit); }));
  Host& first = a.runs(kUnit) ? a : b;
  Host& second = a.runs(kUnit) ? b : a;
  first.cut();
  ASSERT_TRUE(farm.pass_until([&] { return second.runs(kUnit); }, 5s));
  first.heal();
  farm.pass(10s);

  EXPECT_TRUE(first.units.empty());
  EXPECT_TRUE(second.runs(kUnit));
  EXPECT_EQ(farm.place(kUnit).term, 2u);
}

TEST_F(LostHosts, WaitsWhileAnotherAgentOfLowerInstanceHasItsName) {
  Host& a = farm.add("a");
  farm.want(kUnit);
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  Host& twin = farm.add("a");
  farm.pass(20s);
  EXPECT_EQ(farm.hosts_of(kUnit).size(), 1u);
  Host& first = a.instance < twin.instance ? a : twin;
  Host& second = a.instance < twin.instance ? twin : a;
  EXPECT_TRUE(first.runs(kUnit));
  EXPECT_EQ(told(second, "calls itself host a"), 1u);

  first.kill();
  EXPECT_TRUE(farm.pass_until([&] { return second.runs(kUnit); }, 6s));
}

TEST_F(LostHosts, PutsDocumentsBackThatTheServerHasLostAndKeepsUnitsGoing) {
  Host& a = farm.add("a");
  farm.add("b");
  want_many(20);
  farm.put(Bucket::Buses, "line1", R"({"bitrate":500000})");
  ASSERT_TRUE(farm.pass_until([&] { return all_run(20); }));
  farm.pass(3s);
  const unsigned starts = a.starts + farm.hosts.back().starts;
  const auto before = farm.hosts_of(unit(7));
  farm.lose_server();
  farm.pass(10s);

  EXPECT_TRUE(all_run(20));
  EXPECT_EQ(a.starts + farm.hosts.back().starts, starts);
  EXPECT_EQ(farm.server.keys(Bucket::Units).size(), 21u);
  EXPECT_EQ(farm.server.keys(Bucket::Buses).size(), 1u);
  EXPECT_EQ(std::vector{farm.place(unit(7)).host}, before);
}

TEST_F(LostHosts, PutsNothingBackThatWasDeletedWhileItWasCutOff) {
  Host& a = farm.add("a");
  Host& b = farm.add("b");
  farm.want(kUnit, at("a"));
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  b.cut();
  farm.remove(Bucket::Units, kUnit.key());
  farm.pass(5s);
  b.heal();
  farm.pass(5s);

  EXPECT_TRUE(farm.server.keys(Bucket::Units).at(kUnit.key()).is_deleted);
  EXPECT_TRUE(a.units.empty());
}

}  // namespace
}  // namespace farm::agent
