#include "daemon/configuration.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "daemon/json_reader.hpp"
#include "daemon/load_reader.hpp"
#include "daemon/motor_file.hpp"
#include "daemon/plant_reader.hpp"
#include "daemon/supply_reader.hpp"
#include "drive/drive_unit.hpp"

namespace axisd {
namespace {

constexpr int kFirstNodeId = kAddressSwitchOff;
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

/// A parameter of the drive objects of @p kind and its value; @p refused says why they would not take it.
template <class Refused>
ParameterValue read_parameter(const JsonReader& json, std::string text, drive::ObjectKind kind,
                              const Refused& refused) {
  const bool of_the_unit = kind == drive::ObjectKind::ControlUnit;
  const auto index = take_index(text);
  const drive::ParameterRow* const row = drive::find_parameter(kind, text);
  if (!index || row == nullptr)
    json.fail(of_the_unit ? "a parameter of the control unit such as p8848 as key"
                          : "a parameter of the axis such as p1120 or p1070[1] as key");
  if (*index >= row->count) json.fail(fmt::format("an index 0 to {} of {} as key", row->count - 1, text));
  const ParameterValue value{row->number, json.number(-kUnlimited, kUnlimited), *index};
  if (const std::optional<drive::ParameterError> error = refused(value)) json.fail(expectation(*error));
  return value;
}

/// The values under the parameters that @p json has as keys.
template <class Refused>
std::vector<ParameterValue> read_parameters(const JsonReader& json, drive::ObjectKind kind,
                                            const Refused& refused) {
  if (!json.is_object()) json.fail("an object");
  std::vector<ParameterValue> values;
  for (const std::string& text : json.keys()) values.push_back(read_parameter(json.at(text), text, kind, refused));
  return values;
}

/// A new unit of @p axes, with an infeed as a drive object if @p has_infeed: what it takes can be configured.
drive::UnitConfiguration trial_unit(const std::vector<AxisConfiguration>& axes, bool has_infeed) {
  drive::UnitConfiguration unit{.axes = {}, .infeed = has_infeed};
  for (const AxisConfiguration& axis : axes)
    unit.axes.push_back(
        {.machine = axis.machine, .load = axis.load, .kind = axis.kind, .inverter = axis.inverter});
  return unit;
}

/// What @p object of a new unit takes, each value by itself.
template <class Object>
std::vector<ParameterValue> read_object_parameters(const JsonReader& json, const Object& object) {
  return read_parameters(json, object.kind(), [&](const ParameterValue& value) {
    Object trial = object;
    const auto written = trial.write(value.number, value.index, value.value);
    return written ? std::nullopt : std::optional{written.error()};
  });
}

/// What a new control unit takes: parameters that it saves.
std::vector<ParameterValue> read_unit_parameters(const JsonReader& json) {
  const drive::DriveUnit trial{{}};
  return read_parameters(json, drive::ObjectKind::ControlUnit, [&](const ParameterValue& value) {
    return trial.object(drive::kControlUnitNumber)->load_error(value.number, value.index, value.value);
  });
}

drive::ObjectKind read_axis_type(const JsonReader& json) {
  const std::string name = json.text();
  const auto* const row = std::ranges::find(kAxisTypes, name, &AxisTypeRow::name);
  if (row == kAxisTypes.end()) json.fail("servo or vector");
  return row->kind;
}

/// What is said of @p axis, over its defaults.
AxisConfiguration read_axis(const JsonReader& json, AxisConfiguration axis) {
  json.expect_object({"name", "type", "motor", "encoder", "load", "plant", "power_unit", "parameters"});
  if (json.has("name")) axis.name = json.at("name").text();
  if (json.has("type")) axis.kind = read_axis_type(json.at("type"));
  if (json.has("motor")) axis.machine = read_motor(json.at("motor"));
  if (json.has("encoder")) read_encoder(json.at("encoder"), axis.machine.encoder);
  if (json.has("load")) axis.load = read_load(json.at("load"), axis.machine);
  if (json.has("plant")) axis.deviation = read_plant(json.at("plant"), axis.machine, axis.load);
  axis.inverter = motor::inverter_for(axis.machine.maximum_current);
  if (json.has("power_unit")) axis.inverter = read_power_unit(json.at("power_unit"), axis.inverter);
  return axis;
}

/// The parameters of all drive objects but the control unit, when it is known which ones there are: an input may
/// be connected to any of them.
void read_object_parameters(const JsonReader& json, Configuration& configuration) {
  const drive::DriveUnit unit{trial_unit(configuration.axes, configuration.infeed.has_value())};
  if (configuration.infeed && json.at("infeed").has("parameters"))
    configuration.infeed->parameters = read_object_parameters(json.at("infeed").at("parameters"), *unit.infeed());
  if (!json.has("axes")) return;
  for (std::size_t i = 0; i < configuration.axes.size(); ++i)
    if (const JsonReader axis = json.at("axes").at(i); axis.has("parameters"))
      configuration.axes[i].parameters = read_object_parameters(axis.at("parameters"), unit.axes()[i]);
}

/// true, or what is said of it; false is none.
std::optional<InfeedConfiguration> read_infeed(const JsonReader& json) {
  if (!json.is_object()) return json.boolean() ? std::optional{InfeedConfiguration{}} : std::nullopt;
  json.expect_object({"name", "parameters"});
  InfeedConfiguration infeed;
  if (json.has("name")) infeed.name = json.at("name").text();
  return infeed;
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
  json.expect_object({"interface", "node_id", "axes", "parameters", "supply", "infeed", "sdo_block", "f08701"});
  Configuration configuration;
  if (json.has("interface")) configuration.address = read_address(json.at("interface"));
  if (json.has("node_id")) configuration.node_id = json.at("node_id").integer(kFirstNodeId, kLastNodeId);
  if (json.has("sdo_block")) configuration.sdo_block = json.at("sdo_block").boolean();
  if (json.has("f08701")) configuration.fault_on_leaving_operational = json.at("f08701").boolean();
  if (json.has("parameters")) configuration.parameters = read_unit_parameters(json.at("parameters"));
  if (json.has("supply")) configuration.supply = read_supply(json.at("supply"));
  if (json.has("infeed")) configuration.infeed = read_infeed(json.at("infeed"));
  if (json.has("axes")) configuration.axes = read_axes(json.at("axes"));
  read_object_parameters(json, configuration);
  return configuration;
}

Configuration load_configuration(const Options& options) {
  Configuration configuration;
  if (!options.config_file.empty()) {
    configuration = parse_configuration(read_text_file(options.config_file), options.config_file);
  }
  override_with(configuration, options);
  return configuration;
}

}  // namespace axisd
