#include "tools/axisctl/fleet/wanted_fleet.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "farm/documents/field_reader.hpp"
#include "json/strict.hpp"

namespace fleet {
namespace {

using farm::FieldReader;
using nlohmann::json;
using Done = tl::expected<void, std::string>;

constexpr std::int64_t kHighestNode = 127;
constexpr std::int64_t kHighestPort = 65535;
constexpr std::int64_t kFirstSerial = 1;
constexpr std::string_view kBusName = "the name of a bus, 1 to 32 letters, digits, '-' and '_'";
/// Of an entry: what is no key of the configuration of a unit in a farm.
constexpr std::array kOwnKeys{"bus", "node_id", "host"};
/// Of a configuration: what a farm says itself.
constexpr std::array kForeignKeys{"interface", "units", "threads", "control_group"};

json member(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? json{} : *found;
}

bool is_integer(const json& value, std::int64_t low, std::int64_t high) {
  return value.is_number_integer() && value >= low && value <= high;
}

/// The first and the last node-ID of @p entry, which @p fields read.
std::pair<int, int> nodes_of(const json& entry, FieldReader& fields) {
  const json node = member(entry, "node_id");
  if (is_integer(node, 0, kHighestNode)) return {node.get<int>(), node.get<int>()};
  const json from = member(node, "from");
  const json to = member(node, "to");
  if (node.size() == 2 && is_integer(from, 1, kHighestNode) && is_integer(to, 1, kHighestNode) && from <= to)
    return {from.get<int>(), to.get<int>()};
  fields.fail("node_id", "an integer 0 to 127, or an object with from and to, 1 to 127", node);
  return {};
}

/// What @p entry says of the configuration of its unit @p number (0..). Devices of profile cia402 have serial
/// numbers one after the other.
json unit_configuration(const json& entry, int number) {
  json configuration = entry;
  for (const char* const key : kOwnKeys) configuration.erase(key);
  const json serial = member(configuration, "serial");
  const bool can_count = serial.is_null() || serial.is_number_integer();
  if (number != 0 && can_count && member(configuration, "profile") == "cia402")
    configuration["serial"] = (serial.is_null() ? kFirstSerial : serial.get<std::int64_t>()) + number;
  return configuration;
}

/// @p what is asked for at @p place; it must not be before.
Done claim(const std::string& what, const std::string& place, WantedFleet& fleet) {
  const auto [known, is_new] = fleet.origins.emplace(what, place);
  if (is_new) return {};
  return tl::unexpected{fmt::format("{}: {} is wanted by {} already", place, what, known->second)};
}

Done read_entry(const json& entry, const std::string& place, WantedFleet& fleet) {
  FieldReader fields{place, entry};
  const std::string bus = fields.name("bus");
  const std::vector<std::string> hosts = fields.names("host");
  const std::pair<int, int> nodes = nodes_of(entry, fields);
  if (bus.empty()) fields.fail("bus", kBusName, member(entry, "bus"));
  for (const char* const key : kForeignKeys)
    if (fields.has(key)) fields.fail(key, "no such key in a farm", member(entry, key));
  if (const auto checked = fields.result(true); !checked) return tl::unexpected{checked.error()};
  for (int node = nodes.first; node <= nodes.second; ++node) {
    const farm::UnitName name{bus, std::to_string(node)};
    if (auto claimed = claim(name.text(), place, fleet); !claimed) return claimed;
    fleet.units[name] = {.configuration = unit_configuration(entry, node - nodes.first), .hosts = hosts};
  }
  return {};
}

Done read_bus(const std::string& name, const json& value, const std::string& place, WantedFleet& fleet) {
  if (!farm::is_name(name)) return tl::unexpected{fmt::format("{}: expected {}", place, kBusName)};
  const auto settings = farm::parse_bus_settings(place, value.dump());
  if (!settings) return tl::unexpected{settings.error()};
  fleet.buses[name] = *settings;
  return claim("bus " + name, place, fleet);
}

}  // namespace

Done read_fleet_file(const json& document, const std::string& file, WantedFleet& fleet) {
  FieldReader fields{file, document};
  fields.allow_only({"units", "buses"});
  const std::vector<json> units = fields.objects("units");
  const json buses = fields.has("buses") ? fields.object("buses") : json::object();
  if (const auto checked = fields.result(true); !checked) return tl::unexpected{checked.error()};
  for (std::size_t at = 0; at < units.size(); ++at)
    if (auto done = read_entry(units[at], fmt::format("{}: /units/{}", file, at), fleet); !done) return done;
  for (const auto& [name, value] : buses.items())
    if (auto done = read_bus(name, value, fmt::format("{}: /buses/{}", file, json_text::quoted_key(name)), fleet);
        !done)
      return done;
  return {};
}

json configuration_of(const json& document) {
  json units = json::array();
  for (const json& entry : document.value("units", json::array())) {
    json unit = entry;
    unit["interface"] = "unix:/" + unit.value("bus", "");
    for (const char* const key : {"bus", "host"}) unit.erase(key);
    // Two units may have one port: they need not be on one host.
    const json modbus = member(unit, "modbus");
    if (modbus == true) unit["modbus"] = {{"port", 0}};
    if (modbus.is_object() && is_integer(member(modbus, "port"), 1, kHighestPort)) unit["modbus"]["port"] = 0;
    units.push_back(std::move(unit));
  }
  return {{"units", std::move(units)}};
}

}  // namespace fleet
