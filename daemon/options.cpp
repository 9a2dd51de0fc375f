#include "daemon/options.hpp"

#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "daemon/version.hpp"

namespace axisd {

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  CLI::App app{"Puts a simulated CANopen drive unit on a SocketCAN interface.", "axisd"};
  const std::map<std::string, LogLevel> levels{{"error", LogLevel::Error},
                                               {"warning", LogLevel::Warning},
                                               {"notice", LogLevel::Notice},
                                               {"info", LogLevel::Info},
                                               {"debug", LogLevel::Debug}};
  app.set_version_flag("--version", std::string{"axisd "} + kVersion);
  app.add_option("--config", options.config_file, "JSON configuration file")->type_name("FILE");
  app.add_option("--interface", options.interface, "CAN interface (default: vcan0)")->type_name("IF");
  app.add_option("--node-id", options.node_id, "node-ID, 1 to 127 (default: 2)")->type_name("N");
  app.add_option("--axes", options.axes, "number of axes (default: 1)")->type_name("N");
  app.add_option("--state-directory", options.state_directory, "where the unit keeps its state")->type_name("DIR");
  app.add_option("--control", options.control, "control socket, or none")->type_name("SOCKET");
  app.add_flag("--check-config", options.check_config, "check the configuration and exit");
  app.add_option("--log-level", options.log_level, "error, warning, notice, info or debug (default: info)")
      ->type_name("LEVEL")
      ->transform(CLI::CheckedTransformer(levels, CLI::ignore_case));
  try {
    app.parse(count, words);
  } catch (const CLI::Success& asked) {
    app.exit(asked, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError{std::string{error.what()} + " (see axisd --help)"};
  }
  return options;
}

}  // namespace axisd
