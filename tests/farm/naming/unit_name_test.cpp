#include "farm/naming/unit_name.hpp"

#include <string>

#include <gtest/gtest.h>

namespace farm {
namespace {

TEST(UnitName, IsReadAsPeopleAndAsKeysHaveIt) {
  const UnitName unit{"line1", "5"};

  EXPECT_EQ(parse_unit_name("line1/5"), unit);
  EXPECT_EQ(parse_unit_key("line1.5"), unit);
  EXPECT_EQ(unit.text(), "line1/5");
  EXPECT_EQ(unit.key(), "line1.5");
}

TEST(UnitName, HasAStationThatHasNoNodeIdYet) {
  EXPECT_EQ(parse_unit_key("line-1.unconfigured-7"), (UnitName{"line-1", "unconfigured-7"}));
}

TEST(UnitName, IsNothingElse) {
  for (const char* const text : {"", "line1", "line1.", ".5", "line1.128", "line1.x", "line 1.5", "a.b.5",
                                 "line1/5", "a23456789012345678901234567890123.5"})
    EXPECT_EQ(parse_unit_key(text), std::nullopt) << text;
}

TEST(UnitName, OfADaemonHasTheLettersThatANameMayHave) {
  EXPECT_EQ(unit_name_of_daemon("vcan0/5"), (UnitName{"vcan0", "5"}));
  EXPECT_EQ(unit_name_of_daemon("unix-can.bus-1a2b3c4d/5"), (UnitName{"unix-can_bus-1a2b3c4d", "5"}));
  EXPECT_EQ(unit_name_of_daemon("udp-multicast-239.74.163.2-1a2b3c4d/7"),
            (UnitName{"udp-multicast-239_74_163_2-1a2b3", "7"}));
  EXPECT_EQ(unit_name_of_daemon("vcan0"), std::nullopt);
}

TEST(Name, HasOneTo32LettersDigitsDashesAndUnderscores) {
  EXPECT_TRUE(is_name("a"));
  EXPECT_TRUE(is_name("Line_1-b"));
  EXPECT_TRUE(is_name(std::string(32, 'x')));
  EXPECT_FALSE(is_name(""));
  EXPECT_FALSE(is_name("a.b"));
  EXPECT_FALSE(is_name(std::string(33, 'x')));
}

TEST(Name, IsMadeOfThatOfAMachine) {
  EXPECT_EQ(name_from("host.example"), "host_example");
  EXPECT_EQ(name_from(std::string(33, 'x')), std::string(32, 'x'));
  EXPECT_EQ(name_from(""), "");
}

}  // namespace
}  // namespace farm
