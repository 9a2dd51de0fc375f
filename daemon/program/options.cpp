#include "daemon/program/options.hpp"

#include <array>
#include <iostream>

#include <CLI/CLI.hpp>

#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "service_options/log_level_option.hpp"
#include "text/number.hpp"
#include "version/version.hpp"

namespace axisd {
namespace {

constexpr std::array kExitRows{
    cli::ExitRow{kDone, "ended by SIGTERM, SIGINT, SIGHUP (unless ignored, as by nohup) or axisctl quit"},
    cli::ExitRow{kFailure, "any other failure"},
    cli::ExitRow{kUsage, "wrong command line or configuration"},
};

/// The decimal number @p text; @p expected says which ones the option takes.
int integer_of(const char* option, const std::string& text, const char* expected) {
  if (const auto value = text::integer<int>(text)) return *value;
  throw UsageError{std::string{option} + ": expected an integer " + expected + ", got \"" + text + '"'};
}

Profile profile_of(const std::string& name) {
  if (const auto profile = profile_named(name)) return *profile;
  throw UsageError{"--profile: expected s120 or cia402, got \"" + name + '"'};
}

/// What options hold as text until it is judged.
struct Words {
  std::string level = kDefaultLogLevel;
  std::optional<std::string> profile{};
  std::optional<std::string> node_id{};
  std::optional<std::string> axes{};
};

void complete(cli::Command& program) {
  offer_log_levels(program);
  cli::offer_choices(program, "--profile", kProfileNames);
}

void add_options(CLI::App& app, Options& options, Words& words) {
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("axisd"));
  app.add_option("--config", options.config_file, "JSON configuration file")->type_name("FILE");
  app.add_option("--interface", options.interface,
                 "CAN interface, unix:PATH, udp-multicast://GROUP:PORT[?interface=NAME] or "
                 "socketcand://HOST:PORT/NAME (default: vcan0)")
      ->type_name("IF")
      ->take_last();
  app.add_option(
         "--bus", options.bus,
         "name of the bus in that of the unit, and of its state and control socket (default: made of --interface)")
      ->type_name("NAME");
  app.add_option("--profile", words.profile,
                 "device that masters see: s120, the drive unit, or cia402, a CiA 402 axis (default: s120)")
      ->type_name("PROFILE");
  app.add_option(
         "--node-id", words.node_id,
         "node-ID, 1 to 127, or 0 for that of p8620, or with cia402 255 for none, which LSS gives (default: 2)")
      ->type_name("N");
  app.add_option("--axes", words.axes, "number of axes, 1 to 8 (default: those of the configuration file, else 1)")
      ->type_name("N");
  app.add_option("--state-directory", options.state_directory, "where the unit keeps its state")->type_name("DIR");
  app.add_option("--control", options.control, "control socket, or none")->type_name("SOCKET");
  app.add_option("--control-group", options.control_group,
                 "group whose members may use the control socket (default: none)")
      ->type_name("GROUP");
  app.add_flag("--check-config", options.check_config, "check the configuration and exit");
  add_log_level(app, words.level);
  cli::add_completion(app, complete);
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words given;
  CLI::App app{"Puts a simulated CANopen drive unit on a CAN bus.", "axisd"};
  add_options(app, options, given);
  try {
    app.parse(count, words);
  } catch (const CLI::Success& asked) {
    app.exit(asked, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError{std::string{error.what()} + " (see axisd --help)"};
  }
  options.log_level = cli::valid(read_log_level(given.level));
  if (given.profile) options.profile = profile_of(*given.profile);
  if (given.node_id) options.node_id = integer_of("--node-id", *given.node_id, "0 to 127");
  if (given.axes) options.axes = integer_of("--axes", *given.axes, "1 to 8");
  return options;
}

}  // namespace axisd
