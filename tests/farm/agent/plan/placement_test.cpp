#include "farm/agent/plan/placement.hpp"

#include <gtest/gtest.h>

namespace farm::agent {
namespace {

using namespace std::chrono_literals;
using canopen::TimePoint;

constexpr TimePoint kStart{1h};
const std::vector<Candidate> kHosts{{"a", 100, 0}, {"b", 100, 0}, {"c", 50, 0}};

std::vector<OpenUnit> units(std::uint64_t first, std::uint64_t count) {
  std::vector<OpenUnit> open;
  for (std::uint64_t i = first; i < first + count; ++i)
    open.push_back({.name = {"line" + std::to_string(i / 100), std::to_string(1 + i % 100)},
                    .order = i,
                    .hosts = {"a", "b", "c"}});
  return open;
}

std::map<std::string, int> counts(const Placement& placement, const std::vector<OpenUnit>& open) {
  std::map<std::string, int> counted;
  for (const OpenUnit& unit : open) ++counted[placement.host_for(unit.name)];
  return counted;
}

TEST(Placement, GivesHostsTheirShareOfTheirCapacity) {
  Placement placement;
  placement.plan(units(0, 250), kHosts, kStart);

  EXPECT_EQ(counts(placement, units(0, 250)), (std::map<std::string, int>{{"a", 100}, {"b", 100}, {"c", 50}}));
}

TEST(Placement, CountsWhatIsPlacedAlready) {
  Placement placement;
  placement.plan(units(0, 10), {{"a", 100, 10}, {"b", 100, 0}}, kStart);

  EXPECT_EQ(counts(placement, units(0, 10)), (std::map<std::string, int>{{"b", 10}}));
}

TEST(Placement, GivesMoreThanTheirCapacityToThoseThatAreLeft) {
  Placement placement;
  placement.plan(units(0, 300), {{"a", 100, 0}, {"b", 50, 0}}, kStart);

  EXPECT_EQ(counts(placement, units(0, 300)), (std::map<std::string, int>{{"a", 200}, {"b", 100}}));
}

TEST(Placement, DoesNotDependOnHowManyAreSeenAtATime) {
  Placement at_once;
  Placement one_by_one;
  at_once.plan(units(0, 50), kHosts, kStart);
  for (std::uint64_t count = 1; count <= 50; ++count) one_by_one.plan(units(0, count), kHosts, kStart);

  for (const OpenUnit& unit : units(0, 50)) EXPECT_EQ(at_once.host_for(unit.name), one_by_one.host_for(unit.name));
}

/// Some are taken already when it is looked at again: the others keep their turn.
TEST(Placement, StaysWhileUnitsAreTaken) {
  Placement placement;
  placement.plan(units(0, 30), kHosts, kStart);
  std::vector<std::string> before;
  for (const OpenUnit& unit : units(10, 20)) before.push_back(placement.host_for(unit.name));
  std::vector<Candidate> hosts = kHosts;
  for (const OpenUnit& unit : units(0, 10))
    ++std::ranges::find(hosts, placement.host_for(unit.name), &Candidate::host)->load;
  placement.plan(units(10, 20), hosts, kStart + 20ms);

  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(placement.host_for(units(10, 20)[i].name), before[i]);
}

TEST(Placement, LeavesOutAHostThatLetsItsTurnPass) {
  Placement placement;
  const auto unit = units(0, 1);
  std::set<std::string> had_a_turn;
  for (int i = 0; i < 3; ++i) {
    placement.plan(unit, kHosts, kStart + i * kTurn);
    had_a_turn.insert(placement.host_for(unit[0].name));
  }
  EXPECT_EQ(had_a_turn, (std::set<std::string>{"a", "b", "c"}));

  placement.plan(unit, kHosts, kStart + 3 * kTurn);
  EXPECT_NE(placement.host_for(unit[0].name), "");
}

TEST(Placement, IsNobodysTurnIfNoHostMayHaveIt) {
  Placement placement;
  placement.plan({{.name = {"line0", "1"}, .order = 1, .hosts = {"x"}}}, kHosts, kStart);

  EXPECT_EQ(placement.host_for({"line0", "1"}), "");
}

TEST(Placement, GoesToAnotherHostWhenItsOwnIsGone) {
  Placement placement;
  placement.plan(units(0, 1), {{"a", 100, 0}}, kStart);
  placement.plan(units(0, 1), {{"b", 100, 0}}, kStart + 1s);

  EXPECT_EQ(placement.host_for(units(0, 1)[0].name), "b");
}

}  // namespace
}  // namespace farm::agent
