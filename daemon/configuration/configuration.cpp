#include "daemon/configuration/configuration.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "daemon/configuration/axis/load_reader.hpp"
#include "daemon/configuration/axis/mechanics_reader.hpp"
#include "daemon/configuration/axis/motor_file.hpp"
#include "daemon/configuration/axis/plant_reader.hpp"
#include "daemon/configuration/base/json_reader.hpp"
#include "daemon/configuration/inject_reader.hpp"
#include "daemon/configuration/modbus_reader.hpp"
#include "daemon/configuration/parameter_reader.hpp"
#include "daemon/configuration/profile/profile_reader.hpp"
#include "daemon/configuration/record_reader.hpp"
#include "daemon/configuration/supply_reader.hpp"
#include "daemon/configuration/trace_reader.hpp"
#include "drive/drive_unit.hpp"
#include "text/name.hpp"

namespace axisd {
namespace {

constexpr std::array kAxisNames{"X", "Y", "Z", "A", "B", "C", "U", "V"};
static_assert(kAxisNames.size() == drive::kMostAxes);

struct AxisTypeRow {
  std::string_view name;
  drive::ObjectKind kind;
};
constexpr std::array kAxisTypes{AxisTypeRow{"servo", drive::ObjectKind::Servo},
                                AxisTypeRow{"vector", drive::ObjectKind::Vector}};

drive::ObjectKind read_axis_type(const JsonReader& json) {
  const std::string name = json.text();
  const auto* const row = std::ranges::find(kAxisTypes, name, &AxisTypeRow::name);
  if (row == kAxisTypes.end()) json.fail("servo or vector");
  return row->kind;
}

/// Whether an axis of @p kind is delivered with its extended setpoint channel.
bool read_setpoint_channel(const JsonReader& json, drive::ObjectKind kind) {
  const bool active = json.boolean();
  if (!active && kind == drive::ObjectKind::Vector) json.fail("true, which a vector axis always has");
  return active;
}

/// A ready wiring of an axis that has a positioner if @p positioner.
drive::PositionerWiring read_positioner_wiring(const JsonReader& json, bool positioner) {
  const std::string name = json.text();
  const auto* const known = std::ranges::find(drive::kPositionerWirings, name);
  if (known == drive::kPositionerWirings.end()) json.fail("mdi, blocks, telegram-110 or telegram-111");
  if (!positioner) json.fail(R"(an axis with "positioner": true)");
  return static_cast<drive::PositionerWiring>(known - drive::kPositionerWirings.begin());
}

/// What is said of @p axis, over its defaults, except its parameters.
AxisConfiguration read_axis(const JsonReader& json, AxisConfiguration axis, const MotorSource& motors) {
  json.expect_object({"name", "type", "motor", "encoder", "load", "plant", "power_unit", "setpoint_channel",
                      "positioner", "positioner_wiring", "switches", "homing_distance", "parameters"});
  if (json.has("name")) axis.name = json.at("name").text();
  if (json.has("type")) axis.kind = read_axis_type(json.at("type"));
  if (json.has("motor")) axis.machine = read_motor(json.at("motor"), motors);
  if (json.has("encoder")) read_encoder(json.at("encoder"), axis.machine.encoder);
  if (json.has("load")) {
    axis.mechanics = read_mechanics(json.at("load"));
    axis.load = read_load(json.at("load"), axis.machine, axis.mechanics);
  }
  if (json.has("plant")) axis.deviation = read_plant(json.at("plant"), axis.machine, axis.load);
  axis.inverter = motor::inverter_for(axis.machine.maximum_current);
  if (json.has("power_unit")) axis.inverter = read_power_unit(json.at("power_unit"), axis.inverter);
  if (json.has("setpoint_channel"))
    axis.setpoint_channel = read_setpoint_channel(json.at("setpoint_channel"), axis.kind);
  if (json.has("positioner")) axis.positioner = json.at("positioner").boolean();
  if (json.has("positioner_wiring"))
    axis.positioner_wiring = read_positioner_wiring(json.at("positioner_wiring"), axis.positioner);
  return axis;
}

/// true, or what is said of it; false is none.
std::optional<InfeedConfiguration> read_infeed(const JsonReader& json) {
  if (!json.is_object()) return json.boolean() ? std::optional{InfeedConfiguration{}} : std::nullopt;
  json.expect_object({"name", "parameters"});
  InfeedConfiguration infeed;
  if (json.has("name")) infeed.name = json.at("name").text();
  return infeed;
}

/// What profile cia402 has beside what both have.
void read_cia402(const JsonReader& json, AxisConfiguration& axis) {
  if (axis.machine.encoder.type == motor::EncoderType::None)
    (json.has("encoder") ? json.at("encoder") : json).fail("an axis with an encoder, which profile cia402 needs");
  axis.cia402 = read_cia402_axis(json);
}

std::vector<AxisConfiguration> read_axes(const JsonReader& json, const MotorSource& motors, bool is_cia402) {
  json.expect_array(1, drive::kMostAxes);
  std::vector<AxisConfiguration> axes;
  FedInputs fed;
  for (std::size_t i = 0; i < json.size(); ++i) {
    AxisConfiguration axis = read_axis(json.at(i), default_axes(i + 1).back(), motors);
    const auto same = std::ranges::find(axes, axis.name, &AxisConfiguration::name);
    if (same != axes.end()) {
      const JsonReader& named = json.at(i).has("name") ? json.at(i).at("name") : json.at(i);
      named.fail(fmt::format("a name that /axes/{} does not have", same - axes.begin()));
    }
    if (is_cia402)
      read_cia402(json.at(i), axis);
    else if (json.at(i).has("switches"))
      axis.switches = read_switches(json.at(i).at("switches"), fed);
    axes.push_back(std::move(axis));
  }
  return axes;
}

bus::Address read_address(const JsonReader& json) {
  auto address = bus::parse_address(json.text());
  if (!address) json.fail(address.error());
  return *std::move(address);
}

std::string read_bus(const JsonReader& json) {
  std::string name = json.text();
  if (!text::is_name(name)) json.fail(fmt::format("a name of {}", text::kNameForm));
  return name;
}

}  // namespace

std::vector<AxisConfiguration> default_axes(std::size_t count) {
  std::vector<AxisConfiguration> axes(count);
  for (std::size_t i = 0; i < count; ++i) axes[i].name = kAxisNames[i];
  return axes;
}

namespace {

constexpr std::array<std::string_view, 17> kKeysOfUnit{
    "interface", "bus",    "profile", "node_id", "axes",   "parameters", "supply", "infeed",          "sdo_block",
    "f08701",    "record", "trace",   "audit",   "modbus", "inject",     "serial", "missed_setpoints"};
/// Units of a program, and threads that run them.
constexpr std::size_t kMostUnits = 1024;
constexpr int kMostThreads = 64;

/// The keys of a file that describes one unit.
std::vector<std::string_view> keys_of_file() {
  std::vector<std::string_view> keys{kKeysOfUnit.begin(), kKeysOfUnit.end()};
  keys.push_back("control_group");
  return keys;
}

std::string read_control_group(const JsonReader& json) {
  if (!json.has("control_group")) return {};
  std::string group = json.at("control_group").text();
  if (group.empty()) json.at("control_group").fail("the name of a group");
  return group;
}

/// What is said of one unit but its node-ID; @p profile in place of the key of that name.
Configuration read_unit(const JsonReader& json, const MotorSource& motors, std::optional<Profile> profile) {
  Configuration configuration;
  configuration.cia402 = read_profile(json, profile);
  if (json.has("interface")) configuration.address = read_address(json.at("interface"));
  if (json.has("bus")) configuration.bus = read_bus(json.at("bus"));
  if (json.has("sdo_block")) configuration.sdo_block = json.at("sdo_block").boolean();
  if (json.has("f08701")) configuration.fault_on_leaving_operational = json.at("f08701").boolean();
  if (json.has("supply")) configuration.supply = read_supply(json.at("supply"));
  if (json.has("infeed")) configuration.infeed = read_infeed(json.at("infeed"));
  if (json.has("axes")) configuration.axes = read_axes(json.at("axes"), motors, configuration.cia402.has_value());
  if (json.has("record")) configuration.record = read_record(json.at("record"));
  if (json.has("trace")) configuration.trace = read_trace(json.at("trace"));
  if (json.has("audit")) configuration.audit = json.at("audit").boolean();
  if (json.has("modbus")) configuration.modbus = read_modbus(json.at("modbus"));
  if (json.has("inject")) configuration.inject = read_faults(json.at("inject"));
  read_parameters(json, configuration);
  return configuration;
}

int read_node_id(const JsonReader& json, const Configuration& unit) {
  return unit.cia402 ? read_cia402_node_id(json) : json.integer(kAddressSwitchOff, kHighestNodeId);
}

/// As many units alike as the node-IDs of @p entry; devices of profile cia402 have serial numbers one after the
/// other.
std::vector<Configuration> units_from(const JsonReader& entry, const Configuration& unit) {
  const JsonReader node = entry.at("node_id");
  node.expect_object({"from", "to"});
  if (!node.has("from") || !node.has("to")) node.fail("an integer 0 to 127, or an object with from and to");
  const int first = node.at("from").integer(1, kHighestNodeId);
  const int last = node.at("to").integer(first, kHighestNodeId);
  const auto last_serial = std::numeric_limits<std::uint32_t>::max() - static_cast<std::uint32_t>(last - first);
  if (unit.cia402 && unit.cia402->serial > last_serial)
    entry.at("serial").fail(fmt::format("an integer 0 to {} for the first of the units", last_serial));
  std::vector<Configuration> units(static_cast<std::size_t>(last - first) + 1, unit);
  for (std::size_t i = 0; i < units.size(); ++i) {
    units[i].node_id = first + static_cast<int>(i);
    if (unit.cia402) units[i].cia402->serial += static_cast<std::uint32_t>(i);
  }
  return units;
}

/// One unit, or as many alike as node_id has room for.
std::vector<Configuration> read_entry(const JsonReader& json, const MotorSource& motors) {
  json.expect_object(kKeysOfUnit);
  Configuration unit = read_unit(json, motors, std::nullopt);
  if (!json.has("node_id")) return {std::move(unit)};
  const JsonReader node = json.at("node_id");
  if (node.is_object()) return units_from(json, unit);
  unit.node_id = read_node_id(node, unit);
  return {std::move(unit)};
}

/// Which entry has which unit, by a name.
using Taken = std::map<std::string, std::size_t>;

/// Takes @p name for @p unit of entry @p place, unless another unit on the bus that is called @p bus has it.
void take_name(Taken& taken, std::string name, const Configuration& unit, const JsonReader& entry,
               std::size_t place, const std::string& bus) {
  const auto [known, is_new] = taken.emplace(std::move(name), place);
  if (is_new) return;
  const bool is_unconfigured = unit.node_id == Cia402Settings::kUnconfigured;
  const char* const key = is_unconfigured ? "serial" : "node_id";
  (entry.has(key) ? entry.at(key) : entry)
      .fail(fmt::format("a {} that /units/{}{} does not have on {}", is_unconfigured ? "serial number" : "node-ID",
                        known->second, is_unconfigured ? ", without node-ID too," : "", bus));
}

/// No two units are on one bus with one node-ID, or are called the same.
class TakenNames {
 public:
  void take(const Configuration& unit, const JsonReader& entry, std::size_t place) {
    const std::string& address = unit.address.text;
    take_name(on_buses_, bus::label(unit.address) + '/' + station_of(unit), unit, entry, place, address);
    take_name(names_, name_of(unit), unit, entry, place, unit.bus.empty() ? address : unit.bus);
  }

 private:
  Taken on_buses_;
  Taken names_;
};

UnitsConfiguration read_units(const JsonReader& json, const MotorSource& motors) {
  json.expect_object({"units", "threads", "control_group"});
  const JsonReader list = json.at("units");
  list.expect_array(1, kMostUnits);
  UnitsConfiguration configuration{
      .units = {}, .threads = 1, .is_list = true, .control_group = read_control_group(json)};
  TakenNames names;
  ModbusPlaces places;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (Configuration& unit : read_entry(list.at(i), motors)) {
      names.take(unit, list.at(i), i);
      if (unit.modbus) places.take(list.at(i), i, *unit.modbus);
      configuration.units.push_back(std::move(unit));
    }
  }
  if (configuration.units.size() > kMostUnits)
    list.fail(fmt::format("at most {} units, got {}", kMostUnits, configuration.units.size()));
  if (json.has("threads"))
    configuration.threads = static_cast<std::size_t>(json.at("threads").integer(1, kMostThreads));
  return configuration;
}

}  // namespace

UnitsConfiguration parse_configuration(std::string_view text, const std::string& file, const MotorSource& motors,
                                       std::optional<Profile> profile) {
  const JsonReader json = JsonReader::parse(text, file);
  if (json.has("units")) return read_units(json, motors);
  json.expect_object(keys_of_file());
  UnitsConfiguration configuration{.units = {read_unit(json, motors, profile)},
                                   .threads = 1,
                                   .is_list = false,
                                   .control_group = read_control_group(json)};
  if (json.has("node_id"))
    configuration.units.front().node_id = read_node_id(json.at("node_id"), configuration.units.front());
  return configuration;
}

}  // namespace axisd
