// The key "profile", and the keys that one profile has alone.
#include <gtest/gtest.h>

#include "tests/daemon/configuration/bad_file.hpp"

namespace axisd {
namespace {

Configuration unit_of(std::string_view text) {
  return parse_configuration(text, "node.json");
}

TEST(Cia402, HasIdentityAndSwitchesOfItsOwn) {
  const Configuration unit =
      unit_of(R"({"profile": "cia402", "node_id": 255, "serial": 4294967295, "missed_setpoints": 0,
      "axes": [{"homing_distance": 12.5, "switches": [{"role": "home", "from": -1, "to": 2, "inverted": true}]}]})");
  ASSERT_TRUE(unit.cia402);
  EXPECT_EQ(unit.node_id, Cia402Settings::kUnconfigured);
  EXPECT_EQ(unit.cia402->serial, 4294967295U);
  EXPECT_EQ(unit.cia402->missed_setpoints, 0U);
  const Cia402AxisSettings& axis = unit.axes.front().cia402;
  EXPECT_EQ(axis.homing_distance, 12.5);
  const auto& home = axis.switches.of(cia402::Signal::Home);
  ASSERT_TRUE(home);
  EXPECT_EQ(home->from, -1.0);
  EXPECT_EQ(home->to, 2.0);
  EXPECT_TRUE(home->inverted);
  EXPECT_FALSE(axis.switches.of(cia402::Signal::NegativeLimit));
}

TEST(Cia402, IsNotWhatAUnitIsWithoutTheKey) {
  EXPECT_FALSE(unit_of("{}").cia402);
  EXPECT_FALSE(unit_of(R"({"profile": "s120"})").cia402);
}

class Profile : public testing::TestWithParam<BadFile> {};

TEST_P(Profile, RefusesKeysOfTheOther) {
  EXPECT_EQ(message_of([] { parse_configuration(GetParam().text, "node.json"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, Profile,
    testing::Values(
        BadFile{R"({"profile": "402"})", "node.json: /profile: expected s120 or cia402, got \"402\""},
        BadFile{R"({"serial": 1})", "node.json: /serial: expected a unit with \"profile\": \"cia402\", got 1"},
        BadFile{R"({"profile": "cia402", "infeed": true})",
                "node.json: /infeed: expected a unit with \"profile\": \"s120\", got true"},
        BadFile{R"({"profile": "cia402", "parameters": {"p8604": 1}})",
                "node.json: /parameters: expected a unit with \"profile\": \"s120\", got {\"p8604\":1}"},
        BadFile{R"({"profile": "cia402", "axes": [{"positioner": true}]})",
                "node.json: /axes/0/positioner: expected a unit with \"profile\": \"s120\", got true"},
        BadFile{R"({"axes": [{"homing_distance": 5}]})",
                "node.json: /axes/0/homing_distance: expected a unit with \"profile\": \"cia402\", got 5"},
        BadFile{R"({"profile": "cia402", "serial": 4294967296})",
                "node.json: /serial: expected an integer 0 to 4294967295, got 4294967296"},
        BadFile{R"({"profile": "cia402", "missed_setpoints": -1})",
                "node.json: /missed_setpoints: expected an integer 0 to 1000, got -1"},
        BadFile{R"({"profile": "cia402", "node_id": 0})",
                "node.json: /node_id: expected an integer 1 to 127, or 255 for a node without node-ID, got 0"},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"role": "end", "from": 1, "to": 2}]}]})",
                "node.json: /axes/0/switches/0/role: expected negative, positive, home, probe1 or probe2, got "
                "\"end\""},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"role": "home", "from": 2, "to": 2}]}]})",
                "node.json: /axes/0/switches/0/to: expected a number above 2, where the switch begins, got 2"},
        BadFile{
            R"({"profile": "cia402", "axes": [{"switches": [{"role": "home", "from": 1, "to": 2}, {"role": "home", "from": 3, "to": 4}]}]})",
            "node.json: /axes/0/switches/1/role: expected a role that no other switch of the axis has, got "
            "\"home\""},
        BadFile{
            R"({"axes": [{"switches": [{"role": "home", "from": 1, "to": 2}]}]})",
            "node.json: /axes/0/switches/0/role: expected a unit with \"profile\": \"cia402\", got \"home\""}));

}  // namespace
}  // namespace axisd
