#include "farm/door/service/roster.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

using nlohmann::json;

const UnitName kFive{"line1", "5"};

json units(const std::vector<std::string>& names) {
  json list = json::array();
  for (const std::string& name : names)
    list.push_back({{"unit", name}, {"on", true}, {"axes", 2}, {"profile", "s120"}, {"node_id", 5}});
  return {{"units", list}};
}

TEST(RosterTest, KnowsUnitsByTheirNamesOnBothSides) {
  Roster roster;

  EXPECT_TRUE(roster.take("a.sock", units({"line1/5", "vcan.0/6"})));

  ASSERT_NE(roster.find(kFive), nullptr);
  EXPECT_EQ(roster.find(kFive)->unit, (DoorUnit{kFive, true, 2, "s120", 5}));
  ASSERT_NE(roster.name_in_farm("vcan.0/6"), nullptr);
  EXPECT_EQ(roster.name_in_farm("vcan.0/6")->text(), "vcan_0/6");
  EXPECT_EQ(roster.find(*roster.name_in_farm("vcan.0/6"))->name, "vcan.0/6");
  EXPECT_EQ(roster.name_in_farm("vcan_0/6"), nullptr);
}

TEST(RosterTest, SaysWhatIsNews) {
  Roster roster;
  EXPECT_TRUE(roster.take("a.sock", units({"line1/5"})));
  EXPECT_FALSE(roster.take("a.sock", units({"line1/5"})));
  EXPECT_TRUE(roster.take("a.sock", units({"line1/6"})));

  EXPECT_FALSE(roster.keep({"a.sock"}));
  EXPECT_TRUE(roster.keep({}));
  EXPECT_TRUE(roster.units().empty());
}

TEST(RosterTest, OfTwoUnitsOfOneNameTheOneOfTheFirstDaemonIsReached) {
  Roster roster;
  roster.take("b.sock", units({"line1/5"}));
  roster.take("a.sock", units({"line1/5"}));

  EXPECT_EQ(roster.units().size(), 1U);
  EXPECT_TRUE(roster.keep({"b.sock"}));
  EXPECT_NE(roster.find(kFive), nullptr);
}

TEST(RosterTest, WhatIsNoUnitIsLeftOut) {
  Roster roster;
  json told = units({"line1/5", "line1", "line1/*", ""});
  told["units"].push_back(5);
  told["units"].push_back({{"unit", "line1/6"}, {"axes", "two"}});

  roster.take("a.sock", told);
  EXPECT_EQ(roster.units().size(), 1U);
  for (const char* const text : {"5", "[]", R"({"units": 5})", R"({"units": {"a": 1}})"})
    roster.take("b.sock", json::parse(text));
  EXPECT_EQ(roster.units().size(), 1U);
}

}  // namespace
}  // namespace farm
