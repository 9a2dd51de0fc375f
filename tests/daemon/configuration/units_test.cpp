// A list of units in one configuration file.
#include <array>
#include <fstream>

#include <gtest/gtest.h>

#include "daemon/program/configuration_file.hpp"
#include "daemon/program/motor_folders.hpp"
#include "daemon/program/options.hpp"
#include "tests/daemon/configuration/bad_file.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

UnitsConfiguration read(const std::string& text) {
  return parse_configuration(text, "units.json", MotorFolders{});
}

TEST(ListOfUnits, IsReadUnitByUnit) {
  const UnitsConfiguration list = read(R"({"threads": 2, "units": [
      {"interface": "vcan0", "node_id": 5, "axes": [{}, {}]}, {"interface": "vcan1", "node_id": 5}]})");

  EXPECT_TRUE(list.is_list);
  EXPECT_EQ(list.threads, 2U);
  ASSERT_EQ(list.units.size(), 2U);
  EXPECT_EQ(list.units[0].axes.size(), 2U);
  EXPECT_EQ(list.units[1].address.text, "vcan1");
  EXPECT_EQ(list.units[1].axes.size(), 1U);
}

TEST(ListOfUnits, AndAFileOfOneUnitNameTheGroupOfTheControlSocket) {
  EXPECT_EQ(read(R"({"units": [{}], "control_group": "axisd"})").control_group, "axisd");
  EXPECT_EQ(read(R"({"control_group": "axisd"})").control_group, "axisd");
  EXPECT_EQ(read(R"({"units": [{}]})").control_group, "");
}

TEST(ListOfUnits, HasAUnitForEachNodeIdOfARange) {
  const UnitsConfiguration list =
      read(R"({"units": [{"node_id": {"from": 1, "to": 127}, "axes": [{}, {}, {}]}]})");

  ASSERT_EQ(list.units.size(), 127U);
  EXPECT_EQ(list.units.front().node_id, 1);
  EXPECT_EQ(list.units.back().node_id, 127);
  EXPECT_EQ(list.units.back().axes.size(), 3U);
}

TEST(ListOfUnits, NamesTheUnitsByTheNamesOfTheirBuses) {
  const UnitsConfiguration list = read(R"({"units": [{"bus": "line1", "node_id": {"from": 5, "to": 6}},
      {"interface": "unix:/tmp/bus", "bus": "line-2"}, {"interface": "can1"}]})");

  EXPECT_EQ(name_of(list.units[1]), "line1/6");
  EXPECT_EQ(name_of(list.units[2]), "line-2/2");
  EXPECT_EQ(folder_of(list.units[2]), "line-2-2");
  EXPECT_EQ(name_of(list.units[3]), "can1/2");
  EXPECT_EQ(bus_of(list.units[3]), "can1");
}

TEST(ListOfUnits, MayServeModbusAtDifferentPlaces) {
  const UnitsConfiguration list = read(R"({"units": [
      {"node_id": 1, "modbus": true}, {"node_id": 2, "modbus": {"port": 503}}, {"node_id": 3, "modbus": false},
      {"node_id": 4, "modbus": {"address": "0:0:0:0:0:0:0:1"}}, {"node_id": {"from": 5, "to": 6}, "modbus": {"port": 0}}]})");

  EXPECT_EQ(list.units[0].modbus, (ModbusSettings{"127.0.0.1", 502}));
  EXPECT_EQ(list.units[1].modbus, (ModbusSettings{"127.0.0.1", 503}));
  EXPECT_EQ(list.units[2].modbus, std::nullopt);
  EXPECT_EQ(list.units[3].modbus, (ModbusSettings{"::1", 502}));
  EXPECT_EQ(list.units[5].modbus, (ModbusSettings{"127.0.0.1", 0}));
}

TEST(ListOfUnits, IsNoListWhereTheFileDescribesOneUnit) {
  EXPECT_FALSE(read("{}").is_list);
  EXPECT_EQ(read("{}").units.size(), 1U);
}

struct Refused {
  const char* text;
  const char* message;
};
class ListThatIsRefused : public testing::TestWithParam<Refused> {};

TEST_P(ListThatIsRefused, SaysWhereAndWhy) {
  EXPECT_EQ(message_of([] { read(GetParam().text); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Reasons, ListThatIsRefused,
    testing::Values(
        Refused{R"({"units": [{"node_id": 5}, {"node_id": 6}, {"node_id": 5}]})",
                "units.json: /units/2/node_id: expected a node-ID that /units/0 does not have on vcan0, got 5"},
        Refused{R"({"units": [{"node_id": {"from": 2, "to": 9}}, {}]})",
                "units.json: /units/1: expected a node-ID that /units/0 does not have on vcan0, got {}"},
        Refused{R"({"units": [{"node_id": 5, "bus": "a"}, {"node_id": 5, "bus": "b"}]})",
                "units.json: /units/1/node_id: expected a node-ID that /units/0 does not have on vcan0, got 5"},
        Refused{R"({"units": [{"interface": "can1", "node_id": 5, "bus": "a"}, {"node_id": 5, "bus": "a"}]})",
                "units.json: /units/1/node_id: expected a node-ID that /units/0 does not have on a, got 5"},
        Refused{R"({"units": [{"interface": "can1"}, {"bus": "can1"}]})",
                "units.json: /units/1: expected a node-ID that /units/0 does not have on can1, got "
                "{\"bus\":\"can1\"}"},
        Refused{R"({"units": [{"node_id": {"from": 9, "to": 2}}]})",
                "units.json: /units/0/node_id/to: expected an integer 9 to 127, got 2"},
        Refused{R"({"units": [{"modbus": true}, {"node_id": 3, "modbus": {"address": "127.0.0.2"}},
                              {"node_id": 4, "modbus": {"port": 502}}]})",
                "units.json: /units/2/modbus: expected a port that /units/0 does not have at this address, got "
                "{\"port\":502}"},
        Refused{R"({"units": [{"modbus": {"port": 1502}},
                              {"node_id": 3, "modbus": {"address": "0.0.0.0", "port": 1502}}]})",
                "units.json: /units/1/modbus: expected a port that /units/0 does not have at this address, got "
                "{\"address\":\"0.0.0.0\",\"port\":1502}"},
        Refused{
            R"({"units": [{"node_id": {"from": 1, "to": 2}, "modbus": true}]})",
            "units.json: /units/0/modbus: expected a port for each of the units that node_id stands for (0: one "
            "that is free), got true"},
        Refused{R"({"units": []})", "units.json: /units: expected an array of 1 to 1024, got []"},
        Refused{R"({"units": [{}], "node_id": 5})",
                "units.json: /node_id: unknown key, expected one of: units, threads, control_group"},
        Refused{R"({"units": [{"control_group": "axisd"}]})",
                "units.json: /units/0/control_group: unknown key, expected one of: interface, bus, profile, "
                "node_id, axes, parameters, supply, infeed, sdo_block, f08701, record, trace, audit, modbus, "
                "inject, serial, "
                "missed_setpoints"},
        Refused{R"({"units": [{}], "control_group": ""})",
                "units.json: /control_group: expected the name of a group, got \"\""},
        Refused{R"({"control_group": 7})", "units.json: /control_group: expected a string, got 7"},
        Refused{R"({"units": [{}], "threads": 0})", "units.json: /threads: expected an integer 1 to 64, got 0"}));

class OptionBesideUnits : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(OptionBesideUnits, IsAUsageError) {
  fakes::TemporaryDirectory folder;
  const std::string file = folder.path("units.json");
  std::ofstream{file} << R"({"units": [{}]})";
  const auto [option, value] = GetParam();
  const std::array<const char*, 5> words{"axisd", "--config", file.c_str(), option, value};
  const Options options = parse_command_line(words.size(), words.data()).value();

  try {
    static_cast<void>(load_configuration(options));
    FAIL() << "accepted";
  } catch (const UsageError& error) {
    EXPECT_EQ(error.what(), std::string{option} + ": expected nothing beside the units of " + file);
  }
}

INSTANTIATE_TEST_SUITE_P(OfOneUnit, OptionBesideUnits,
                         testing::Values(std::pair{"--interface", "can3"}, std::pair{"--bus", "line1"},
                                         std::pair{"--node-id", "3"}, std::pair{"--axes", "3"},
                                         std::pair{"--profile", "cia402"}));

}  // namespace
}  // namespace axisd
