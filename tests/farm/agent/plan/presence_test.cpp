#include "farm/agent/plan/presence.hpp"

#include <gtest/gtest.h>

namespace farm::agent {
namespace {

using namespace std::chrono_literals;
using canopen::TimePoint;

constexpr TimePoint kStart{1h};
const UnitName kUnit{"line1", "5"};

AgentBeat agent(const std::string& host, std::uint64_t instance) {
  return {.host = host, .instance = instance};
}

DoorBeat door(const std::string& host, std::vector<UnitName> units) {
  DoorBeat beat{.host = host, .instance = 1};
  for (const UnitName& unit : units) beat.units.push_back({.name = unit});
  return beat;
}

class PresenceTest : public testing::Test {
 protected:
  void SetUp() override { presence.listen(kStart); }

  Presence presence;
};

TEST_F(PresenceTest, LosesAHostWhoseAgentAndDoorAreSilent) {
  presence.on_agent(agent("a", 1), kStart);
  presence.on_door(door("a", {kUnit}), kStart + 200ms);

  EXPECT_FALSE(presence.is_lost("a", kUnit, kStart + 2199ms));
  EXPECT_TRUE(presence.is_lost("a", kUnit, kStart + 2200ms));
}

TEST_F(PresenceTest, KeepsAUnitThatItsDoorHasWhileItsAgentIsDead) {
  presence.on_agent(agent("a", 1), kStart);
  for (int i = 0; i < 20; ++i) presence.on_door(door("a", {kUnit}), kStart + i * 250ms);

  EXPECT_FALSE(presence.is_lost("a", kUnit, kStart + 5s));
  EXPECT_TRUE(presence.is_lost("a", {"line1", "6"}, kStart + 5s));
}

TEST_F(PresenceTest, LosesAUnitThatItsDoorDoesNotHaveWhileItsAgentIsDead) {
  presence.on_agent(agent("a", 1), kStart);
  presence.on_door(door("a", {kUnit}), kStart);
  for (int i = 1; i < 20; ++i) presence.on_door(door("a", {}), kStart + i * 250ms);

  EXPECT_TRUE(presence.is_lost("a", kUnit, kStart + 5s));
}

TEST_F(PresenceTest, KnowsNobodysSilenceBeforeItHasListened) {
  EXPECT_FALSE(presence.is_lost("a", kUnit, kStart + 1999ms));
  EXPECT_TRUE(presence.is_lost("a", kUnit, kStart + 2s));

  presence.listen(kStart + 10s);
  EXPECT_FALSE(presence.is_lost("a", kUnit, kStart + 11s));
}

TEST_F(PresenceTest, KnowsWhereAUnitIsByAllPartsOfWhatADoorTells) {
  DoorBeat first = door("a", {{"line1", "1"}});
  DoorBeat second = door("a", {kUnit});
  first.parts = second.parts = second.part = 2;
  presence.on_door(first, kStart);
  presence.on_door(second, kStart);

  EXPECT_EQ(presence.host_with(kUnit, kStart + 1s), "a");
  EXPECT_EQ(presence.host_with(kUnit, kStart + 3s), std::nullopt);
  second.units.clear();
  presence.on_door(second, kStart + 1s);
  EXPECT_EQ(presence.host_with(kUnit, kStart + 1s), std::nullopt);
}

TEST_F(PresenceTest, KnowsWhoHasTheNameOfAHostBeforeIt) {
  presence.on_agent(agent("a", 7), kStart);

  EXPECT_EQ(presence.rival("a", 9, kStart), 7u);
  EXPECT_EQ(presence.rival("a", 7, kStart), std::nullopt);
  EXPECT_EQ(presence.rival("a", 3, kStart), std::nullopt);
  EXPECT_EQ(presence.rival("a", 9, kStart + 2s), std::nullopt);
}

TEST_F(PresenceTest, HasOneAgentAHost) {
  presence.on_agent(agent("a", 7), kStart);
  presence.on_agent(agent("a", 5), kStart);
  presence.on_agent(agent("b", 6), kStart);

  const auto agents = presence.agents(kStart);
  ASSERT_EQ(agents.size(), 2u);
  EXPECT_EQ(agents[0].instance, 5u);
  EXPECT_TRUE(presence.agents(kStart + 2s).empty());
}

}  // namespace
}  // namespace farm::agent
