#include "daemon/program/options.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>

#include "cli/completion.hpp"
#include "daemon/version.hpp"
#include "text/number.hpp"

namespace axisd {
namespace {

struct LevelRow {
  std::string_view name;
  LogLevel level;
};
constexpr std::array kLevels{LevelRow{"error", LogLevel::Error}, LevelRow{"warning", LogLevel::Warning},
                             LevelRow{"notice", LogLevel::Notice}, LevelRow{"info", LogLevel::Info},
                             LevelRow{"debug", LogLevel::Debug}};

LogLevel level_named(const std::string& name) {
  const auto row = std::find_if(kLevels.begin(), kLevels.end(), [&](const LevelRow& r) { return r.name == name; });
  if (row != kLevels.end()) return row->level;
  throw UsageError{"--log-level: expected error, warning, notice, info or debug, got \"" + name + '"'};
}

/// The decimal number @p text; @p expected says which ones the option takes.
int integer_of(const char* option, const std::string& text, const char* expected) {
  if (const auto value = text::integer<int>(text)) return *value;
  throw UsageError{std::string{option} + ": expected an integer " + expected + ", got \"" + text + '"'};
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  CLI::App app{"Puts a simulated CANopen drive unit on a CAN bus.", "axisd"};
  std::string level = "info";
  std::optional<std::string> node_id;
  std::optional<std::string> axes;
  app.set_version_flag("--version", std::string{"axisd "} + kVersion);
  app.add_option("--config", options.config_file, "JSON configuration file")->type_name("FILE");
  app.add_option("--interface", options.interface,
                 "CAN interface, unix:PATH, udp-multicast://GROUP:PORT[?interface=NAME] or "
                 "socketcand://HOST:PORT/NAME (default: vcan0)")
      ->type_name("IF")
      ->take_last();
  app.add_option("--node-id", node_id, "node-ID, 1 to 127, or 0 for that of p8620 (default: 2)")->type_name("N");
  app.add_option("--axes", axes, "number of axes, 1 to 8 (default: those of the configuration file, else 1)")
      ->type_name("N");
  app.add_option("--state-directory", options.state_directory, "where the unit keeps its state")->type_name("DIR");
  app.add_option("--control", options.control, "control socket, or none")->type_name("SOCKET");
  app.add_flag("--check-config", options.check_config, "check the configuration and exit");
  app.add_option("--log-level", level, "error, warning, notice, info or debug (default: info)")
      ->type_name("LEVEL");
  cli::add_completion(app, [](cli::Command& program) {
    for (cli::Option& option : program.options)
      if (option.names.back() == "--log-level")
        for (const LevelRow& row : kLevels) {
          option.value.kind = cli::Kind::Choices;
          option.value.choices.emplace_back(row.name);
        }
  });
  try {
    app.parse(count, words);
  } catch (const CLI::Success& asked) {
    app.exit(asked, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError{std::string{error.what()} + " (see axisd --help)"};
  }
  options.log_level = level_named(level);
  if (node_id) options.node_id = integer_of("--node-id", *node_id, "0 to 127");
  if (axes) options.axes = integer_of("--axes", *axes, "1 to 8");
  return options;
}

}  // namespace axisd
