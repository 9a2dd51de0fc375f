// The profile of a unit, and what only one of them has.
#include <fstream>

#include <gtest/gtest.h>

#include "tests/daemon/configuration/bad_file.hpp"
#include "tests/daemon/configuration/command_line.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

Configuration read(const std::string& text) {
  return parse_configuration(text, "node.json");
}

TEST(Profile, IsThatOfTheDriveUnitUnlessOtherwiseSaid) {
  EXPECT_EQ(read("{}").profile(), Profile::Unit);
  EXPECT_EQ(read(R"({"profile": "s120"})").profile(), Profile::Unit);
  EXPECT_EQ(read(R"({"profile": "cia402"})").profile(), Profile::Cia402);
}

TEST(Profile, Cia402HasFactoryValues) {
  const Configuration unit = read(R"({"profile": "cia402", "axes": [{}]})");

  EXPECT_EQ(unit.node_id, 2);
  ASSERT_TRUE(unit.cia402);
  EXPECT_EQ(unit.cia402->serial, 1U);
  EXPECT_EQ(unit.cia402->missed_setpoints, 3U);
  EXPECT_EQ(unit.axes[0].cia402.homing_distance, 200.0);
  for (const cia402::Signal signal : {cia402::Signal::NegativeLimit, cia402::Signal::Home, cia402::Signal::Probe2})
    EXPECT_FALSE(unit.axes[0].cia402.switches.of(signal));
}

TEST(Profile, Cia402TakesItsKeys) {
  const Configuration unit = read(R"({"profile": "cia402", "node_id": 255, "serial": 4294967295,
    "missed_setpoints": 0, "axes": [{"homing_distance": 2.5, "motor": "1ft7044", "load": {"gear": 3},
      "switches": [{"role": "negative", "from": -5, "to": -4, "inverted": true}, {"role": "positive", "from": 4, "to": 5},
                   {"role": "home", "from": 0, "to": 0.25}, {"role": "probe1", "from": 1, "to": 2},
                   {"role": "probe2", "from": 2, "to": 3}]}]})");

  EXPECT_EQ(unit.node_id, Cia402Settings::kUnconfigured);
  EXPECT_EQ(unit.cia402->serial, 4294967295U);
  EXPECT_EQ(unit.cia402->missed_setpoints, 0U);
  EXPECT_EQ(unit.axes[0].cia402.homing_distance, 2.5);
  const auto negative = unit.axes[0].cia402.switches.of(cia402::Signal::NegativeLimit);
  ASSERT_TRUE(negative);
  EXPECT_EQ(negative->from, -5.0);
  EXPECT_EQ(negative->to, -4.0);
  EXPECT_TRUE(negative->inverted);
  const auto home = unit.axes[0].cia402.switches.of(cia402::Signal::Home);
  ASSERT_TRUE(home);
  EXPECT_EQ(home->to, 0.25);
  EXPECT_FALSE(home->inverted);
  EXPECT_TRUE(unit.axes[0].cia402.switches.of(cia402::Signal::Probe2));
}

TEST(Profile, OfAListIsThatOfEachUnit) {
  const auto units = parse_configuration(R"({"units": [{"node_id": 1}, {"profile": "cia402", "node_id": 2},
      {"profile": "cia402", "serial": 7, "node_id": {"from": 3, "to": 5}}]})",
                                         "units.json", MotorFolders{})
                         .units;

  ASSERT_EQ(units.size(), 5U);
  EXPECT_EQ(units[0].profile(), Profile::Unit);
  EXPECT_EQ(units[1].cia402->serial, 1U);
  EXPECT_EQ(units[2].cia402->serial, 7U) << "serial numbers of units alike count up";
  EXPECT_EQ(units[4].cia402->serial, 9U);
}

TEST(UnitName, HasTheNodeIdOrThatThereIsNone) {
  const auto name = [](const std::string& keys) { return name_of(read("{" + keys + "}")); };
  EXPECT_EQ(name(""), "vcan0/2");
  EXPECT_EQ(name(R"("node_id": 0)"), "vcan0/0");
  EXPECT_EQ(name(R"("profile": "cia402", "node_id": 5, "serial": 7)"), "vcan0/5");
  EXPECT_EQ(name(R"("profile": "cia402", "node_id": 255)"), "vcan0/unconfigured");
  EXPECT_EQ(name(R"("profile": "cia402", "node_id": 255, "serial": 1)"), "vcan0/unconfigured");
  EXPECT_EQ(name(R"("profile": "cia402", "node_id": 255, "serial": 7, "interface": "can1")"),
            "can1/unconfigured-7");
  EXPECT_EQ(name(R"("profile": "cia402", "node_id": 255, "serial": 0)"), "vcan0/unconfigured-0");
}

TEST(UnitName, TellsTwoWithoutNodeIdApart) {
  const auto units = parse_configuration(R"({"units": [{"profile": "cia402", "node_id": 255},
      {"profile": "cia402", "node_id": 255, "serial": 2}, {"interface": "can1", "profile": "cia402", "node_id": 255}]})",
                                         "units.json", MotorFolders{})
                         .units;

  EXPECT_EQ(name_of(units[0]), "vcan0/unconfigured");
  EXPECT_EQ(name_of(units[1]), "vcan0/unconfigured-2");
  EXPECT_EQ(name_of(units[2]), "can1/unconfigured");
}

class BadProfiles : public testing::TestWithParam<BadFile> {};

TEST_P(BadProfiles, AreRefusedWithFilePlaceAndExpectation) {
  EXPECT_EQ(message_of([] { parse_configuration(GetParam().text, "node.json"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Values, BadProfiles,
    testing::Values(
        BadFile{R"({"profile": "402"})", "node.json: /profile: expected s120 or cia402, got \"402\""},
        BadFile{R"({"profile": 402})", "node.json: /profile: expected a string, got 402"},
        BadFile{R"({"profile": "cia402", "serial": -1})",
                "node.json: /serial: expected an integer 0 to 4294967295, got -1"},
        BadFile{R"({"profile": "cia402", "serial": 4294967296})",
                "node.json: /serial: expected an integer 0 to 4294967295, got 4294967296"},
        BadFile{R"({"profile": "cia402", "missed_setpoints": 1001})",
                "node.json: /missed_setpoints: expected an integer 0 to 1000, got 1001"},
        BadFile{R"({"profile": "cia402", "missed_setpoints": 1.5})",
                "node.json: /missed_setpoints: expected an integer 0 to 1000, got 1.5"},
        BadFile{R"({"profile": "cia402", "node_id": 0})",
                "node.json: /node_id: expected an integer 1 to 127, or 255 for a node without node-ID, got 0"},
        BadFile{R"({"profile": "cia402", "node_id": 128})",
                "node.json: /node_id: expected an integer 1 to 127, or 255 for a node without node-ID, got 128"},
        BadFile{R"({"profile": "cia402", "node_id": "5"})",
                "node.json: /node_id: expected an integer 1 to 127, or 255 for a node without node-ID, got \"5\""},
        BadFile{R"({"node_id": 255})", "node.json: /node_id: expected an integer 0 to 127, got 255"},
        BadFile{R"({"profile": "cia402", "axes": [{"homing_distance": 0}]})",
                "node.json: /axes/0/homing_distance: expected a number 0.001 to 1000000000, got 0"},
        BadFile{R"({"profile": "cia402", "axes": [{}, {"encoder": {"type": "none"}}]})",
                "node.json: /axes/1/encoder: expected an axis with an encoder, which profile cia402 needs, got "
                "{\"type\":\"none\"}"}));

INSTANTIATE_TEST_SUITE_P(
    Switches, BadProfiles,
    testing::Values(
        BadFile{R"({"profile": "cia402", "axes": [{"switches": {}}]})",
                "node.json: /axes/0/switches: expected an array of 0 to 5, got {}"},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"role": "home", "from": 1}]}]})",
                "node.json: /axes/0/switches/0: expected the key to, got {\"from\":1,\"role\":\"home\"}"},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"role": "index", "from": 1, "to": 2}]}]})",
                "node.json: /axes/0/switches/0/role: expected negative, positive, home, probe1 or probe2, got "
                "\"index\""},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"role": "home", "from": 1, "to": 2},
                                                               {"role": "home", "from": 3, "to": 4}]}]})",
                "node.json: /axes/0/switches/1/role: expected a role that no other switch of the axis has, got "
                "\"home\""},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"role": "home", "from": 2, "to": 2}]}]})",
                "node.json: /axes/0/switches/0/to: expected a number above 2, where the switch begins, got 2"},
        BadFile{
            R"({"profile": "cia402", "axes": [{"switches": [{"role": "home", "from": -1e10, "to": 2}]}]})",
            "node.json: /axes/0/switches/0/from: expected a number -1000000000 to 1000000000, got -10000000000.0"},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"role": "home", "from": 1, "to": 2,
                                                               "inverted": 1}]}]})",
                "node.json: /axes/0/switches/0/inverted: expected true or false, got 1"},
        BadFile{R"({"profile": "cia402", "axes": [{"switches": [{"input": 1, "from": 1, "to": 2}]}]})",
                "node.json: /axes/0/switches/0/input: expected a unit with \"profile\": \"s120\", got 1"},
        BadFile{
            R"({"axes": [{"switches": [{"role": "home", "from": 1, "to": 2}]}]})",
            "node.json: /axes/0/switches/0/role: expected a unit with \"profile\": \"cia402\", got \"home\""}));

INSTANTIATE_TEST_SUITE_P(
    KeysOfTheOtherProfile, BadProfiles,
    testing::Values(
        BadFile{R"({"serial": 7})", "node.json: /serial: expected a unit with \"profile\": \"cia402\", got 7"},
        BadFile{R"({"profile": "s120", "missed_setpoints": 0})",
                "node.json: /missed_setpoints: expected a unit with \"profile\": \"cia402\", got 0"},
        BadFile{R"({"axes": [{}, {"homing_distance": 5}]})",
                "node.json: /axes/1/homing_distance: expected a unit with \"profile\": \"cia402\", got 5"},
        BadFile{R"({"profile": "cia402", "parameters": {}})",
                "node.json: /parameters: expected a unit with \"profile\": \"s120\", got {}"},
        BadFile{R"({"profile": "cia402", "infeed": true})",
                "node.json: /infeed: expected a unit with \"profile\": \"s120\", got true"},
        BadFile{R"({"profile": "cia402", "sdo_block": true})",
                "node.json: /sdo_block: expected a unit with \"profile\": \"s120\", got true"},
        BadFile{R"({"profile": "cia402", "f08701": false})",
                "node.json: /f08701: expected a unit with \"profile\": \"s120\", got false"},
        BadFile{R"({"profile": "cia402", "modbus": true})",
                "node.json: /modbus: expected a unit with \"profile\": \"s120\", got true"},
        BadFile{R"({"profile": "cia402", "axes": [{"setpoint_channel": true}]})",
                "node.json: /axes/0/setpoint_channel: expected a unit with \"profile\": \"s120\", got true"},
        BadFile{R"({"profile": "cia402", "axes": [{"positioner": true}]})",
                "node.json: /axes/0/positioner: expected a unit with \"profile\": \"s120\", got true"},
        BadFile{R"({"profile": "cia402", "axes": [{"positioner_wiring": "mdi"}]})",
                "node.json: /axes/0/positioner_wiring: expected a unit with \"profile\": \"s120\", got \"mdi\""},
        BadFile{R"({"profile": "cia402", "axes": [{"parameters": {"p1120": 1}}]})",
                "node.json: /axes/0/parameters: expected a unit with \"profile\": \"s120\", got {\"p1120\":1}"}));

INSTANTIATE_TEST_SUITE_P(
    Lists, BadProfiles,
    testing::Values(
        BadFile{
            R"({"units": [{"profile": "cia402", "node_id": 255}, {"profile": "cia402", "node_id": 255}]})",
            "node.json: /units/1: expected a serial number that /units/0, without node-ID too, does not have on "
            "vcan0, got {\"node_id\":255,\"profile\":\"cia402\"}"},
        BadFile{
            R"({"units": [{"profile": "cia402", "node_id": 255, "serial": 3},
                              {"profile": "cia402", "node_id": 255, "serial": 3}]})",
            "node.json: /units/1/serial: expected a serial number that /units/0, without node-ID too, does not "
            "have on vcan0, got 3"},
        BadFile{R"({"units": [{"profile": "cia402", "node_id": 5}, {"node_id": 5}]})",
                "node.json: /units/1/node_id: expected a node-ID that /units/0 does not have on vcan0, got 5"},
        BadFile{R"({"units": [{"profile": "cia402", "serial": 4294967290, "node_id": {"from": 1, "to": 9}}]})",
                "node.json: /units/0/serial: expected an integer 0 to 4294967287 for the first of the units, got "
                "4294967290"}));

/// A configuration file, and what the command line lays over it.
struct ProfileOption : testing::Test {
  std::string file(const std::string& text) const {
    const std::string name = folder.path("node.json");
    std::ofstream{name} << text;
    return name;
  }
  fakes::TemporaryDirectory folder;
};

TEST_F(ProfileOption, IsInPlaceOfTheKey) {
  EXPECT_EQ(configuration_of({"--profile", "cia402"}).profile(), Profile::Cia402);
  EXPECT_EQ(configuration_of({"--profile", "s120"}).profile(), Profile::Unit);
  EXPECT_EQ(configuration_of({"--profile", "cia402", "--config", file(R"({"profile": "s120", "serial": 4})")})
                .cia402->serial,
            4U);
  EXPECT_EQ(configuration_of({"--profile", "s120", "--config", file(R"({"profile": "cia402"})")}).profile(),
            Profile::Unit);
}

TEST_F(ProfileOption, LeavesNoRoomForKeysOfTheOther) {
  const std::string name = file(R"({"parameters": {"p8848": 1}})");

  EXPECT_EQ(message_of([&] {
              configuration_of({"--profile", "cia402", "--config", name});
            }),
            name + ": /parameters: expected a unit with \"profile\": \"s120\", got {\"p8848\":1}");
}

TEST_F(ProfileOption, SaysWhichNodeIdsThereAre) {
  EXPECT_EQ(station_of(configuration_of({"--profile", "cia402", "--node-id", "255"})), "unconfigured");
  EXPECT_EQ(configuration_of({"--profile", "cia402", "--node-id", "127"}).node_id, 127);
  EXPECT_EQ(message_of([] {
              configuration_of({"--profile", "cia402", "--node-id", "0"});
            }),
            "--node-id: expected an integer 1 to 127, or 255 for a node without node-ID, got 0");
  EXPECT_EQ(message_of([] {
              configuration_of({"--node-id", "255"});
            }),
            "--node-id: expected an integer 0 to 127, got 255");
}

}  // namespace
}  // namespace axisd
