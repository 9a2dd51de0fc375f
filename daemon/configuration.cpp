#include "daemon/configuration.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "daemon/json_reader.hpp"
#include "drive/axis.hpp"

namespace axisd {
namespace {

constexpr int kFirstNodeId = 1;
constexpr int kLastNodeId = 127;
constexpr std::array kAxisNames{"X", "Y", "Z", "A", "B", "C", "U", "V"};
static_assert(kAxisNames.size() == drive::kMostAxes);

struct AxisTypeRow {
  std::string_view name;
  drive::ObjectKind kind;
};
constexpr std::array kAxisTypes{AxisTypeRow{"servo", drive::ObjectKind::Servo},
                                AxisTypeRow{"vector", drive::ObjectKind::Vector}};
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

/// The number in brackets behind a parameter such as p1070[1], 0 if there is none; @p text loses it.
std::optional<std::uint8_t> take_index(std::string& text) {
  const std::size_t bracket = text.find('[');
  if (bracket == std::string::npos) return std::uint8_t{0};
  std::uint8_t index = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + bracket + 1, end, index);
  if (error != std::errc{} || std::string_view{rest, end} != "]") return std::nullopt;
  text.resize(bracket);
  return index;
}

ParameterValue read_parameter(const JsonReader& json, std::string text, const AxisConfiguration& configuration) {
  drive::Axis trial{{.machine = configuration.machine, .load = configuration.load, .kind = configuration.kind}};
  const auto index = take_index(text);
  const drive::ParameterRow* const row = drive::find_parameter(trial.kind(), text);
  if (!index || row == nullptr) json.fail("a parameter of the axis such as p1120 or p1070[1] as key");
  if (*index >= row->count) json.fail(fmt::format("an index 0 to {} of {} as key", row->count - 1, text));
  const double value = json.number(-kUnlimited, kUnlimited);
  if (const auto written = trial.write(row->number, *index, value); !written)
    json.fail(expectation(written.error()));
  return {row->number, value, *index};
}

drive::ObjectKind read_axis_type(const JsonReader& json) {
  const std::string name = json.text();
  const auto* const row = std::ranges::find(kAxisTypes, name, &AxisTypeRow::name);
  if (row == kAxisTypes.end()) json.fail("servo or vector");
  return row->kind;
}

/// What is said of @p axis, over its defaults.
AxisConfiguration read_axis(const JsonReader& json, AxisConfiguration axis) {
  json.expect_object({"name", "type", "motor", "load", "parameters"});
  if (json.has("name")) axis.name = json.at("name").text();
  if (json.has("type")) axis.kind = read_axis_type(json.at("type"));
  if (json.has("motor")) axis.machine = read_motor(json.at("motor"));
  if (json.has("load")) axis.load = read_load(json.at("load"));
  if (!json.has("parameters")) return axis;
  const JsonReader parameters = json.at("parameters");
  if (!parameters.is_object()) parameters.fail("an object");
  for (const std::string& text : parameters.keys())
    axis.parameters.push_back(read_parameter(parameters.at(text), text, axis));
  return axis;
}

std::vector<AxisConfiguration> read_axes(const JsonReader& json) {
  json.expect_array(1, drive::kMostAxes);
  std::vector<AxisConfiguration> axes;
  for (std::size_t i = 0; i < json.size(); ++i) {
    AxisConfiguration axis = read_axis(json.at(i), default_axes(i + 1).back());
    const auto same = std::ranges::find(axes, axis.name, &AxisConfiguration::name);
    if (same != axes.end()) {
      const JsonReader& named = json.at(i).has("name") ? json.at(i).at("name") : json.at(i);
      named.fail(fmt::format("a name that /axes/{} does not have", same - axes.begin()));
    }
    axes.push_back(std::move(axis));
  }
  return axes;
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

/// Takes the last axes away, or adds default ones whose names are free.
void resize_axes(std::vector<AxisConfiguration>& axes, int count) {
  if (count < 1 || static_cast<std::size_t>(count) > drive::kMostAxes)
    throw ConfigurationError{fmt::format("--axes: expected an integer 1 to {}, got {}", drive::kMostAxes, count)};
  for (AxisConfiguration& axis : default_axes(drive::kMostAxes)) {
    const bool taken = std::ranges::find(axes, axis.name, &AxisConfiguration::name) != axes.end();
    if (!taken && axes.size() < static_cast<std::size_t>(count)) axes.push_back(std::move(axis));
  }
  axes.resize(static_cast<std::size_t>(count));
}

void override_with(Configuration& configuration, const Options& options) {
  if (options.interface) override_address(configuration, *options.interface);
  if (options.node_id) configuration.node_id = *options.node_id;
  if (configuration.node_id < kFirstNodeId || configuration.node_id > kLastNodeId) {
    throw ConfigurationError{fmt::format("--node-id: expected an integer {} to {}, got {}", kFirstNodeId,
                                         kLastNodeId, configuration.node_id)};
  }
  if (options.axes) resize_axes(configuration.axes, *options.axes);
}

}  // namespace

std::vector<AxisConfiguration> default_axes(std::size_t count) {
  std::vector<AxisConfiguration> axes(count);
  for (std::size_t i = 0; i < count; ++i) axes[i].name = kAxisNames[i];
  return axes;
}

Configuration parse_configuration(std::string_view text, const std::string& file) {
  const JsonReader json = JsonReader::parse(text, file);
  json.expect_object({"interface", "node_id", "axes", "sdo_block", "f08701"});
  Configuration configuration;
  if (json.has("interface")) configuration.address = read_address(json.at("interface"));
  if (json.has("node_id")) configuration.node_id = json.at("node_id").integer(kFirstNodeId, kLastNodeId);
  if (json.has("sdo_block")) configuration.sdo_block = json.at("sdo_block").boolean();
  if (json.has("f08701")) configuration.fault_on_leaving_operational = json.at("f08701").boolean();
  if (json.has("axes")) configuration.axes = read_axes(json.at("axes"));
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
