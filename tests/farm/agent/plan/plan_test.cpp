#include "farm/agent/plan/plan.hpp"

#include <gtest/gtest.h>

#include "tests/farm/agent/plan/told_farm.hpp"

namespace farm::agent {
namespace {

using namespace std::chrono_literals;
using told::Host;

const UnitName kUnit{"line1", "5"};

UnitName unit(int number) {
  return {"line" + std::to_string(1 + number / 100), std::to_string(1 + number % 100)};
}

std::string at(const std::string& host) {
  return R"({"configuration":{},"host":")" + host + "\"}";
}

class PlanTest : public testing::Test {
 protected:
  void TearDown() override { EXPECT_EQ(farm.faults, std::vector<std::string>{}); }

  void want_many(int count) {
    for (int i = 0; i < count; ++i) farm.want(unit(i));
  }
  bool all_run(int count) {
    for (int i = 0; i < count; ++i)
      if (!farm.runs_once(unit(i))) return false;
    return true;
  }
  static std::size_t told(const Host& host, const std::string& part) {
    return static_cast<std::size_t>(std::ranges::count_if(
        host.notices, [&](const std::string& line) { return line.find(part) != std::string::npos; }));
  }

  told::Farm farm;
};

TEST_F(PlanTest, StartsAUnitThatIsWanted) {
  farm.add("a");
  farm.pass(3s);
  farm.want(kUnit);

  EXPECT_TRUE(farm.pass_until([&] { return farm.runs_once(kUnit); }, 1s));
  EXPECT_EQ(farm.place(kUnit).host, "a");
  EXPECT_EQ(farm.place(kUnit).term, 1u);
}

TEST_F(PlanTest, SharesUnitsByCapacityOfHostsThatStartTogether) {
  want_many(250);
  Host& a = farm.add("a", 100);
  Host& b = farm.add("b", 100);
  Host& c = farm.add("c", 50);

  EXPECT_TRUE(farm.pass_until([&] { return all_run(250); }, 5s));
  EXPECT_NEAR(static_cast<double>(a.units.size()), 100, 3);
  EXPECT_NEAR(static_cast<double>(b.units.size()), 100, 3);
  EXPECT_NEAR(static_cast<double>(c.units.size()), 50, 3);
}

TEST_F(PlanTest, MovesNothingMerelyToBalance) {
  want_many(10);
  farm.add("a");
  ASSERT_TRUE(farm.pass_until([&] { return all_run(10); }));
  Host& b = farm.add("b");
  farm.pass(20s);

  EXPECT_TRUE(b.units.empty());
}

TEST_F(PlanTest, RunsTheUnitsOfALostHostElsewhereWithinFiveSeconds) {
  for (const char* const name : {"a", "b", "c"}) farm.add(name);
  want_many(90);
  ASSERT_TRUE(farm.pass_until([&] { return all_run(90); }));
  farm.hosts.front().kill();

  EXPECT_TRUE(farm.pass_until([&] { return all_run(90); }, 5s));
  EXPECT_NEAR(static_cast<double>(farm.hosts.back().units.size()), 45, 2);
}

TEST_F(PlanTest, StartsAUnitElsewhereWithWhatItHasSaved) {
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

TEST_F(PlanTest, LeavesUnitsToAHostWhoseAgentAloneIsDead) {
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

TEST_F(PlanTest, TakesAUnitThatHasEndedOnAHostWithoutAgent) {
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

TEST_F(PlanTest, StopsItsUnitsWithoutContactAndStartsThoseThatAreItsOwnAfterwards) {
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

TEST_F(PlanTest, KeepsItsUnitsThroughAShortCut) {
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

TEST_F(PlanTest, StopsAUnitThatOthersHaveTakenMeanwhile) {
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

TEST_F(PlanTest, RestartsAUnitWhoseConfigurationHasChangedAndNoOther) {
  Host& a = farm.add("a");
  want_many(3);
  ASSERT_TRUE(farm.pass_until([&] { return all_run(3); }));
  farm.want(unit(1), R"({"configuration":{"axes":[{},{}]}})");

  ASSERT_TRUE(farm.pass_until([&] { return a.starts == 4 && all_run(3); }, 3s));
  EXPECT_EQ(a.units.at(unit(1)).configuration, R"({"axes":[{},{}]})");
}

TEST_F(PlanTest, KeepsAUnitGoingWhoseChangedDocumentCannotBeUsed) {
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

TEST_F(PlanTest, SaysOnceWhyADocumentIsNone) {
  Host& a = farm.add("a");
  farm.want(kUnit, R"({"configuration":{"bad":1}})");
  farm.want({"line1", "6"});
  farm.pass(20s);

  EXPECT_EQ(farm.place(kUnit).problem, "no configuration");
  EXPECT_EQ(farm.place(kUnit).host, "a");
  EXPECT_EQ(told(a, "line1/5: no configuration"), 1u);
  EXPECT_TRUE(a.runs({"line1", "6"}));
}

TEST_F(PlanTest, SwitchesAUnitOffThatIsWantedNoMore) {
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

TEST_F(PlanTest, MovesAUnitWhoseHostHasChanged) {
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

TEST_F(PlanTest, GivesTheUnitsOfAHostAwayThatDrains) {
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

TEST_F(PlanTest, TakesUnitsOfItsBusesAlone) {
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

TEST_F(PlanTest, SaysThatNoHostIsThereThatMayHaveAUnit) {
  farm.add("a");
  farm.want(kUnit, at("b"));

  EXPECT_TRUE(
      farm.pass_until([&] { return farm.place(kUnit).problem == "no host that it may be on is there"; }, 5s));
  farm.add("b");
  EXPECT_TRUE(farm.pass_until([&] { return farm.runs_once(kUnit); }, 5s));
  EXPECT_EQ(farm.place(kUnit).problem, "");
}

TEST_F(PlanTest, LeavesAUnitAloneThatADaemonOfNoAgentHas) {
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

TEST_F(PlanTest, StartsAUnitAgainThatHasEndedAndCountsIt) {
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

TEST_F(PlanTest, WaitsWhileAnotherAgentOfLowerInstanceHasItsName) {
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

TEST_F(PlanTest, PutsDocumentsBackThatTheServerHasLostAndKeepsUnitsGoing) {
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

TEST_F(PlanTest, PutsNothingBackThatWasDeletedWhileItWasCutOff) {
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

TEST_F(PlanTest, WritesNothingWhileNothingChanges) {
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
