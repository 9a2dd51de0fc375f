#include "daemon/program/configuration_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "daemon/configuration/parameter_reader.hpp"
#include "daemon/program/motor_folders.hpp"
#include "drive/drive_unit.hpp"
#include "os/regular_file.hpp"
#include "text/name.hpp"

namespace axisd {
namespace {

/// Of a configuration or a motor (bytes).
constexpr std::size_t kLongestFile = std::size_t{16} << 20;

void override_address(Configuration& configuration, const std::string& text) {
  auto address = bus::parse_address(text);
  if (!address)
    throw ConfigurationError{fmt::format("--interface: expected {}, got \"{}\"", address.error(), text)};
  configuration.address = *std::move(address);
}

void override_bus(Configuration& configuration, const std::string& name) {
  if (!text::is_name(name))
    throw ConfigurationError{fmt::format("--bus: expected a name of {}, got \"{}\"", text::kNameForm, name)};
  configuration.bus = name;
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

/// Throws ConfigurationError for a node-ID that no unit of this profile has.
void override_node_id(Configuration& configuration, int node_id) {
  configuration.node_id = node_id;
  const bool is_cia402 = configuration.profile() == Profile::Cia402;
  if (is_cia402 && node_id == Cia402Settings::kUnconfigured) return;
  const int lowest = is_cia402 ? kAddressSwitchOff + 1 : kAddressSwitchOff;
  if (node_id >= lowest && node_id <= kHighestNodeId) return;
  const std::string expected = is_cia402 ? std::string{kCia402NodeIds}
                                         : fmt::format("an integer {} to {}", kAddressSwitchOff, kHighestNodeId);
  throw ConfigurationError{fmt::format("--node-id: expected {}, got {}", expected, node_id)};
}

void override_with(Configuration& configuration, const Options& options) {
  if (options.interface) override_address(configuration, *options.interface);
  if (options.bus) override_bus(configuration, *options.bus);
  if (options.node_id) override_node_id(configuration, *options.node_id);
  if (!options.axes) return;
  resize_axes(configuration.axes, *options.axes);
  if (const auto refused = refused_parameter(configuration))
    throw ConfigurationError{
        fmt::format("--axes: expected the axis that {} is connected to, got {}", *refused, *options.axes)};
}

/// An option that says something of one unit, if there is any.
const char* option_of_one_unit(const Options& options) {
  if (options.interface) return "--interface";
  if (options.bus) return "--bus";
  if (options.profile) return "--profile";
  if (options.node_id) return "--node-id";
  return options.axes ? "--axes" : nullptr;
}

}  // namespace

tl::expected<std::string, std::string> read_text_file(const std::string& file) {
  auto content = os::read_regular_file(file, kLongestFile);
  if (content) return *std::move(content);
  return tl::unexpected{fmt::format("{}: cannot be read: {}", file, content.error().reason())};
}

UnitsConfiguration load_configuration(const Options& options) {
  UnitsConfiguration configuration;
  if (!options.config_file.empty()) {
    const auto text = read_text_file(options.config_file);
    if (!text) throw ConfigurationError{text.error()};
    configuration = parse_configuration(*text, options.config_file, MotorFolders{}, options.profile);
  } else if (options.profile == Profile::Cia402) {
    configuration.units.front().cia402 = Cia402Settings{};
  }
  if (configuration.is_list) {
    if (const char* const option = option_of_one_unit(options))
      throw UsageError{fmt::format("{}: expected nothing beside the units of {}", option, options.config_file)};
    return configuration;
  }
  override_with(configuration.units.front(), options);
  return configuration;
}

}  // namespace axisd
