#include <gtest/gtest.h>

#include "tests/farm/agent/plan/plan_fixture.hpp"

namespace farm::agent {
namespace {

using namespace std::chrono_literals;
using told::at;
using told::Host;
using told::kUnit;
using told::unit;

using WantedUnits = told::PlanTest;

TEST_F(WantedUnits, StartsAUnitThatIsWanted) {
  farm.add("a");
  farm.pass(3s);
  farm.want(kUnit);

  EXPECT_TRUE(farm.pass_until([&] { return farm.runs_once(kUnit); }, 1s));
  EXPECT_EQ(farm.place(kUnit).host, "a");
  EXPECT_EQ(farm.place(kUnit).term, 1u);
}

TEST_F(WantedUnits, SharesUnitsByCapacityOfHostsThatStartTogether) {
  want_many(250);
  Host& a = farm.add("a", 100);
  Host& b = farm.add("b", 100);
  Host& c = farm.add("c", 50);

  EXPECT_TRUE(farm.pass_until([&] { return all_run(250); }, 5s));
  EXPECT_NEAR(static_cast<double>(a.units.size()), 100, 3);
  EXPECT_NEAR(static_cast<double>(b.units.size()), 100, 3);
  EXPECT_NEAR(static_cast<double>(c.units.size()), 50, 3);
}

TEST_F(WantedUnits, MovesNothingMerelyToBalance) {
  want_many(10);
  farm.add("a");
  ASSERT_TRUE(farm.pass_until([&] { return all_run(10); }));
  Host& b = farm.add("b");
  farm.pass(20s);

  EXPECT_TRUE(b.units.empty());
}

TEST_F(WantedUnits, RestartsAUnitWhoseConfigurationHasChangedAndNoOther) {
  Host& a = farm.add("a");
  want_many(3);
  ASSERT_TRUE(farm.pass_until([&] { return all_run(3); }));
  farm.want(unit(1), R"({"configuration":{"axes":[{},{}]}})");

  ASSERT_TRUE(farm.pass_until([&] { return a.starts == 4 && all_run(3); }, 3s));
  EXPECT_EQ(a.units.at(unit(1)).configuration, R"({"axes":[{},{}]})");
}

TEST_F(WantedUnits, KeepsAUnitGoingWhoseChangedDocumentCannotBeUsed) {
  Host& a = farm.add("a");
  farm.want(kUnit);
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  farm.want(kUnit, R"({"configuration":{"bad":1}})");
  EXPECT_TRUE(farm.pass_until([&] { return farm.place(kUnit).problem == "no configuration"; }, 3s));
  farm.want(kUnit, "nonsense");
  farm.pass(1s);
  EXPECT_EQ(farm.place(kUnit).problem, "line1.5: line 1, column 2: expected valid JSON");
  EXPECT_EQ(a.starts, 1u);
  EXPECT_TRUE(a.runs(kUnit));

  farm.want(kUnit);
  EXPECT_TRUE(farm.pass_until([&] { return farm.place(kUnit).problem.empty(); }, 3s));
  EXPECT_EQ(a.starts, 1u);
}

TEST_F(WantedUnits, SaysOnceWhyADocumentIsNone) {
  Host& a = farm.add("a");
  farm.want(kUnit, R"({"configuration":{"bad":1}})");
  farm.want({"line1", "6"});
  farm.pass(20s);

  EXPECT_EQ(farm.place(kUnit).problem, "no configuration");
  EXPECT_EQ(farm.place(kUnit).host, "a");
  EXPECT_EQ(told(a, "line1/5: no configuration"), 1u);
  EXPECT_TRUE(a.runs({"line1", "6"}));
}

TEST_F(WantedUnits, JudgesADocumentAgainThatCouldNotBeJudged) {
  Host& a = farm.add("a");
  a.cannot_judge = true;
  farm.want(kUnit);
  EXPECT_TRUE(farm.pass_until([&] { return farm.place(kUnit).problem == "no room on the disk"; }));
  farm.pass(5s);
  EXPECT_EQ(told(a, "line1/5: no room on the disk"), 1u);
  EXPECT_FALSE(a.runs(kUnit));

  a.cannot_judge = false;
  EXPECT_TRUE(farm.pass_until([&] { return a.runs(kUnit) && farm.place(kUnit).problem.empty(); }));
}

TEST_F(WantedUnits, SwitchesAUnitOffThatIsWantedNoMore) {
  Host& a = farm.add("a");
  farm.want(kUnit);
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  farm.remove(Bucket::Units, kUnit.key());

  EXPECT_TRUE(farm.pass_until([&] { return a.units.empty() && a.hubs.empty(); }, 3s));
  farm.pass(1s);
  EXPECT_EQ(text_of(farm.place(kUnit)), R"({"term":1})");

  farm.want(kUnit);
  EXPECT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }, 3s));
  EXPECT_EQ(farm.place(kUnit).term, 2u);
}

TEST_F(WantedUnits, MovesAUnitWhoseHostHasChanged) {
  Host& a = farm.add("a");
  Host& b = farm.add("b");
  farm.want(kUnit, at("a"));
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  a.save(kUnit);
  farm.pass(100ms);
  farm.want(kUnit, at("b"));

  ASSERT_TRUE(farm.pass_until([&] { return b.runs(kUnit); }, 3s));
  EXPECT_TRUE(a.units.empty());
  EXPECT_NE(b.units.at(kUnit).value, 0);
}

TEST_F(WantedUnits, GivesTheUnitsOfAHostAwayThatDrains) {
  Host& a = farm.add("a");
  Host& b = farm.add("b");
  want_many(20);
  ASSERT_TRUE(farm.pass_until([&] { return all_run(20); }));
  farm.put(Bucket::Hosts, "a", R"({"drain":true})");
  EXPECT_TRUE(farm.pass_until([&] { return all_run(20) && a.units.empty(); }, 5s));
  EXPECT_TRUE(a.plan->beat(farm.now).draining);

  farm.remove(Bucket::Hosts, "a");
  b.plan->drain();
  EXPECT_TRUE(farm.pass_until([&] { return all_run(20) && b.plan->is_empty(); }, 5s));
}

TEST_F(WantedUnits, TakesUnitsOfItsBusesAlone) {
  Host& a = farm.add("a");
  a.kill();
  a.buses = {"line1"};
  a.boot();
  Host& b = farm.add("b", 1000);
  want_many(101);

  ASSERT_TRUE(farm.pass_until([&] { return all_run(101); }));
  EXPECT_TRUE(b.runs(unit(100)));
  b.kill();
  farm.pass(10s);
  EXPECT_EQ(farm.hosts_of(unit(100)), std::vector<std::string>{});
  EXPECT_EQ(a.units.size(), 100u);
}

TEST_F(WantedUnits, SaysThatNoHostIsThereThatMayHaveAUnit) {
  farm.add("a");
  farm.want(kUnit, at("b"));

  EXPECT_TRUE(
      farm.pass_until([&] { return farm.place(kUnit).problem == "no host that it may be on is there"; }, 5s));
  farm.add("b");
  EXPECT_TRUE(farm.pass_until([&] { return farm.runs_once(kUnit); }, 5s));
  EXPECT_EQ(farm.place(kUnit).problem, "");
}

TEST_F(WantedUnits, LeavesAUnitAloneThatADaemonOfNoAgentHas) {
  Host& a = farm.add("a");
  Host& b = farm.add("b");
  a.foreign.insert(kUnit);
  farm.pass(1s);
  farm.want(kUnit);
  farm.pass(20s);

  EXPECT_EQ(farm.hosts_of(kUnit), std::vector<std::string>{});
  EXPECT_EQ(farm.place(kUnit).problem, "it is there already, at host a, from a daemon that no agent has started");
  EXPECT_EQ(told(a, "line1/5: it is there already") + told(b, "line1/5: it is there already"), 1u);

  a.foreign.clear();
  EXPECT_TRUE(farm.pass_until([&] { return farm.runs_once(kUnit); }, 5s));
  EXPECT_EQ(farm.place(kUnit).problem, "");
}

TEST_F(WantedUnits, StartsAUnitAgainThatHasEndedAndCountsIt) {
  Host& a = farm.add("a");
  farm.want(kUnit);
  ASSERT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }));
  a.kill_unit(kUnit);
  EXPECT_TRUE(farm.pass_until([&] { return !farm.place(kUnit).problem.empty(); }, 1s));

  EXPECT_TRUE(farm.pass_until([&] { return a.runs(kUnit); }, 3s));
  farm.pass(1s);
  EXPECT_EQ(farm.place(kUnit).restarts, 1u);
  EXPECT_EQ(farm.place(kUnit).problem, "");
}

TEST_F(WantedUnits, WritesNothingWhileNothingChanges) {
  farm.add("a");
  farm.add("b");
  want_many(20);
  ASSERT_TRUE(farm.pass_until([&] { return all_run(20); }));
  farm.pass(5s);
  const auto writes = farm.server.writes;
  farm.pass(60s);

  EXPECT_EQ(farm.server.writes, writes);
}

}  // namespace
}  // namespace farm::agent
