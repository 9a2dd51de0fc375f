#include "daemon/configuration.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "daemon/json_reader.hpp"
#include "drive/axis.hpp"

namespace axisd {
namespace {

constexpr int kFirstNodeId = 1;
constexpr int kLastNodeId = 127;
constexpr std::size_t kMaximumAxes = 1;
constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kHighestTorque = 1e6;  // N·m

struct MotorPreset {
  std::string_view name;
  motor::MachineData data;
};
constexpr std::array kMotorPresets{MotorPreset{"1fk7063", motor::MachineData{}}};

std::string read_file(const std::string& name) {
  std::ifstream file{name};
  if (!file) throw ConfigurationError{fmt::format("{}: cannot be read: {}", name, std::strerror(errno))};
  try {
    return std::string{std::istreambuf_iterator<char>{file}, {}};
  } catch (const std::ios_base::failure& error) {  // a folder opens, but cannot be read
    throw ConfigurationError{fmt::format("{}: cannot be read: {}", name, error.code().message())};
  }
}

/// A key of a motor file and where its value belongs; the factor makes the unit in the key an SI unit.
struct MotorKey {
  const char* key;
  double motor::MachineData::*member;
  double factor;
};
constexpr std::array kMotorKeys{
    MotorKey{"rated_speed_rpm", &motor::MachineData::rated_speed, motor::kRpm},
    MotorKey{"maximum_speed_rpm", &motor::MachineData::maximum_speed, motor::kRpm},
    MotorKey{"rated_torque_Nm", &motor::MachineData::rated_torque, 1.0},
    MotorKey{"maximum_torque_Nm", &motor::MachineData::maximum_torque, 1.0},
    MotorKey{"inertia_kgm2", &motor::MachineData::inertia, 1.0},
};

motor::MachineData read_motor_file(const std::string& name) {
  const JsonReader json = JsonReader::parse(read_file(name), name);
  json.expect_object(
      {"rated_speed_rpm", "maximum_speed_rpm", "rated_torque_Nm", "maximum_torque_Nm", "inertia_kgm2"});
  motor::MachineData data;
  for (const MotorKey& row : kMotorKeys) {
    constexpr double kSmallest = 1e-9;
    if (json.has(row.key)) data.*row.member = row.factor * json.at(row.key).number(kSmallest, kUnlimited);
  }
  return data;
}

motor::MachineData read_motor(const JsonReader& json) {
  const std::string motor = json.text();
  for (const MotorPreset& preset : kMotorPresets) {
    if (preset.name == motor) return preset.data;
  }
  if (motor.find_first_of("./") == std::string::npos)
    json.fail("a motor preset (1fk7063) or the path of a motor file");
  return read_motor_file(json.folder() / motor);  // an absolute path stands for itself
}

void read_load_torque(const JsonReader& json, motor::Load& load) {
  if (!json.is_object()) {
    load.constant_torque = json.number(-kHighestTorque, kHighestTorque);
    return;
  }
  if (!json.has("type")) json.fail("a number (N·m) or an object with the key type");
  const std::string type = json.at("type").text();
  if (type == "hoist") {
    json.expect_object({"type", "mass", "radius"});
    for (const char* const key : {"mass", "radius"}) {
      if (!json.has(key)) json.fail(fmt::format("the key {}", key));
    }
    load.constant_torque =
        motor::hoist_torque(json.at("mass").number(0, kUnlimited), json.at("radius").number(0, kUnlimited));
    if (load.constant_torque > kHighestTorque)
      json.fail(fmt::format("mass and radius that make at most {} N·m", kHighestTorque));
  } else if (type == "fan") {
    json.expect_object({"type", "coefficient"});
    if (!json.has("coefficient")) json.fail("the key coefficient (N·m·s²)");
    load.fan_coefficient = json.at("coefficient").number(0, kUnlimited);
  } else {
    json.at("type").fail("hoist or fan");
  }
}

motor::Load read_load(const JsonReader& json) {
  json.expect_object({"inertia", "friction", "torque"});
  motor::Load load;
  if (json.has("inertia")) load.inertia = json.at("inertia").number(0, kUnlimited);
  if (json.has("friction")) {
    const JsonReader friction = json.at("friction");
    friction.expect_object({"coulomb", "viscous"});
    if (friction.has("coulomb")) load.coulomb_friction = friction.at("coulomb").number(0, kUnlimited);
    if (friction.has("viscous")) load.viscous_friction = friction.at("viscous").number(0, kUnlimited);
  }
  if (json.has("torque")) read_load_torque(json.at("torque"), load);
  return load;
}

/// What should have been written instead of what @p error refused.
std::string expectation(const drive::ParameterError& error) {
  using drive::Refusal;
  const drive::ParameterRow& row = *error.row;
  const bool number = error.reason == Refusal::BelowMinimum || error.reason == Refusal::AboveMaximum ||
                      error.reason == Refusal::WrongType;
  if (!number) return fmt::format("no such value ({})", drive::message(error));
  const drive::Range limits = drive::limits_of(row);
  const std::string_view unit = drive::row_of(row.unit).text;
  return fmt::format("{} {} to {}{}{}", row.type == drive::DataType::F32 ? "a number" : "an integer",
                     limits.minimum, limits.maximum, unit.empty() ? "" : " ", unit);
}

ParameterValue read_parameter(const JsonReader& json, const std::string& text) {
  drive::Axis trial{drive::AxisConfiguration{}};
  const drive::ParameterRow* const row = drive::find_parameter(trial.kind(), text);
  if (row == nullptr) json.fail("a parameter of the axis such as p1120 as key");
  const double value = json.number(-kUnlimited, kUnlimited);
  if (const auto written = trial.write(row->number, value); !written) json.fail(expectation(written.error()));
  return {row->number, value};
}

AxisConfiguration read_axis(const JsonReader& json) {
  json.expect_object({"name", "type", "motor", "load", "parameters"});
  AxisConfiguration axis;
  if (json.has("name")) axis.name = json.at("name").text();
  if (json.has("type") && json.at("type").text() != "servo") json.at("type").fail("servo");
  if (json.has("motor")) axis.machine = read_motor(json.at("motor"));
  if (json.has("load")) axis.load = read_load(json.at("load"));
  if (!json.has("parameters")) return axis;
  const JsonReader parameters = json.at("parameters");
  if (!parameters.is_object()) parameters.fail("an object");
  for (const std::string& text : parameters.keys())
    axis.parameters.push_back(read_parameter(parameters.at(text), text));
  return axis;
}

bus::Address read_address(const JsonReader& json) {
  auto address = bus::parse_address(json.text());
  if (!address) json.fail(address.error());
  return *std::move(address);
}

void override_address(Configuration& configuration, const std::string& text) {
  auto address = bus::parse_address(text);
  if (!address)
    throw ConfigurationError{fmt::format("--interface: expected {}, got \"{}\"", address.error(), text)};
  configuration.address = *std::move(address);
}

void override_with(Configuration& configuration, const Options& options) {
  if (options.interface) override_address(configuration, *options.interface);
  if (options.node_id) configuration.node_id = *options.node_id;
  if (configuration.node_id < kFirstNodeId || configuration.node_id > kLastNodeId) {
    throw ConfigurationError{fmt::format("--node-id: expected an integer {} to {}, got {}", kFirstNodeId,
                                         kLastNodeId, configuration.node_id)};
  }
  if (options.axes && *options.axes != 1) {
    throw ConfigurationError{fmt::format("--axes: expected 1 in this version, got {}", *options.axes)};
  }
}

}  // namespace

Configuration parse_configuration(std::string_view text, const std::string& file) {
  const JsonReader json = JsonReader::parse(text, file);
  json.expect_object({"interface", "node_id", "axes", "sdo_block", "f08701"});
  Configuration configuration;
  if (json.has("interface")) configuration.address = read_address(json.at("interface"));
  if (json.has("node_id")) configuration.node_id = json.at("node_id").integer(kFirstNodeId, kLastNodeId);
  if (json.has("sdo_block")) configuration.sdo_block = json.at("sdo_block").boolean();
  if (json.has("f08701")) configuration.fault_on_leaving_operational = json.at("f08701").boolean();
  if (!json.has("axes")) return configuration;
  const JsonReader axes = json.at("axes");
  axes.expect_array(1, kMaximumAxes);
  configuration.axes.clear();
  for (std::size_t i = 0; i < axes.size(); ++i) configuration.axes.push_back(read_axis(axes.at(i)));
  return configuration;
}

Configuration load_configuration(const Options& options) {
  Configuration configuration;
  if (!options.config_file.empty()) {
    configuration = parse_configuration(read_file(options.config_file), options.config_file);
  }
  override_with(configuration, options);
  return configuration;
}

}  // namespace axisd
