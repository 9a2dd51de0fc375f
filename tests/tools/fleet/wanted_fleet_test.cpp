#include "tools/axisctl/fleet/wanted_fleet.hpp"

#include <gtest/gtest.h>

namespace fleet {
namespace {

using nlohmann::json;

/// What @p text is refused with; empty if it is not.
std::string refusal(const std::string& text, WantedFleet fleet = {}) {
  const auto read = read_fleet_file(json::parse(text), "f.json", fleet);
  return read ? "" : read.error();
}

TEST(FleetFile, AsksForUnitsAndBuses) {
  WantedFleet fleet;
  const json document = json::parse(R"({"units": [{"bus": "line1", "node_id": 5, "host": "a", "axes": [{}, {}]},
                                                   {"bus": "line2", "node_id": {"from": 1, "to": 3}, "host": ["a", "b"]}],
                                        "buses": {"line1": {"bitrate": 500000}}})");

  ASSERT_TRUE(read_fleet_file(document, "f.json", fleet));

  ASSERT_EQ(fleet.units.size(), 4U);
  const farm::WantedUnit& first = fleet.units.at({"line1", "5"});
  EXPECT_EQ(first.configuration, json::parse(R"({"axes": [{}, {}]})"));
  EXPECT_EQ(first.hosts, std::vector<std::string>{"a"});
  EXPECT_EQ(fleet.units.at({"line2", "3"}).hosts, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(fleet.buses.at("line1").bit_rate, 500'000U);
}

TEST(FleetFile, GivesDevicesSerialNumbersOneAfterTheOther) {
  WantedFleet fleet;
  const json document = json::parse(
      R"({"units": [{"bus": "b", "node_id": {"from": 7, "to": 8}, "profile": "cia402", "serial": 100},
                    {"bus": "c", "node_id": {"from": 7, "to": 8}, "profile": "cia402"}]})");
  ASSERT_TRUE(read_fleet_file(document, "f.json", fleet));
  EXPECT_EQ(fleet.units.at({"b", "7"}).configuration["serial"], 100);
  EXPECT_EQ(fleet.units.at({"b", "8"}).configuration["serial"], 101);
  EXPECT_FALSE(fleet.units.at({"c", "7"}).configuration.contains("serial"));
  EXPECT_EQ(fleet.units.at({"c", "8"}).configuration["serial"], 2);
}

TEST(FleetFile, IsRefusedInOneLineThatSaysWhere) {
  EXPECT_EQ(refusal("[]"), "f.json: expected an object, got []");
  EXPECT_EQ(refusal(R"({"unit": []})"), "f.json: unit: expected only units, buses, got []");
  EXPECT_EQ(
      refusal(R"({"units": [{"node_id": 5}]})"),
      "f.json: /units/0: bus: expected the name of a bus, 1 to 32 letters, digits, '-' and '_', got nothing");
  EXPECT_EQ(
      refusal(R"({"units": [{"bus": "a", "node_id": 5}, {"bus": "a", "node_id": 200}]})"),
      "f.json: /units/1: node_id: expected an integer 0 to 127, or an object with from and to, 1 to 127, got 200");
  EXPECT_EQ(
      refusal(R"({"units": [{"bus": "a", "node_id": 1, "host": "a b"}]})"),
      "f.json: /units/0: host: expected a name of 1 to 32 letters, digits, '-' and '_', or a list of them, got "
      "\"a b\"");
  EXPECT_EQ(refusal(R"({"units": [{"bus": "a", "node_id": 1, "interface": "vcan0"}]})"),
            "f.json: /units/0: interface: expected no such key in a farm, got \"vcan0\"");
  EXPECT_EQ(refusal(R"({"buses": {"a": {"bitrate": 5}}})"),
            "f.json: /buses/a: bitrate: expected 0, or 1000 to 1000000, got 5");
  EXPECT_EQ(refusal(R"({"buses": {"a b": {}}})"),
            "f.json: /buses/a b: expected the name of a bus, 1 to 32 letters, digits, '-' and '_'");
}

TEST(FleetFile, MayNotAskForAUnitTwice) {
  EXPECT_EQ(refusal(R"({"units": [{"bus": "a", "node_id": {"from": 1, "to": 5}}, {"bus": "a", "node_id": 5}]})"),
            "f.json: /units/1: a/5 is wanted by f.json: /units/0 already");

  WantedFleet fleet;
  ASSERT_TRUE(read_fleet_file(json::parse(R"({"units": [{"bus": "a", "node_id": 5}]})"), "other.json", fleet));
  EXPECT_EQ(refusal(R"({"units": [{"bus": "a", "node_id": 5}]})", fleet),
            "f.json: /units/0: a/5 is wanted by other.json: /units/0 already");
}

TEST(FleetFile, IsAConfigurationOfUnitsInTheSamePlaces) {
  const json document = json::parse(R"({"units": [{"bus": "a", "node_id": 1, "host": "h", "modbus": true},
                                                   {"bus": "a", "node_id": 2, "modbus": {"port": 502, "address": "x"}},
                                                   {"bus": "a", "node_id": 3, "modbus": {"port": -1}}]})");
  EXPECT_EQ(configuration_of(document),
            json::parse(R"({"units": [{"interface": "unix:/a", "node_id": 1, "modbus": {"port": 0}},
                                      {"interface": "unix:/a", "node_id": 2, "modbus": {"port": 0, "address": "x"}},
                                      {"interface": "unix:/a", "node_id": 3, "modbus": {"port": -1}}]})"));
}

}  // namespace
}  // namespace fleet
