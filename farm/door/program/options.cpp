#include "farm/door/program/options.hpp"

#include <array>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/nats_options/nats_options.hpp"
#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "control/socket_name.hpp"
#include "farm/options/farm_option.hpp"
#include "farm/options/host_option.hpp"
#include "service_options/log_level_option.hpp"
#include "version/version.hpp"

namespace farm {

namespace {

constexpr const char* kDescription = "The door of a host on a farm: its units are reached over a NATS server.";
constexpr std::array kExitRows{cli::ExitRow{kDone, "ended by SIGTERM or SIGINT"},
                               cli::ExitRow{kFailure, "failed: the kernel gives no descriptor or thread"},
                               cli::ExitRow{kUsage, "wrong usage"}};

/// The words that stand behind options, as they were given.
struct Words {
  std::string farm;
  std::string host;
  std::string level = axisd::kDefaultLogLevel;
  nats::ServerOptions security;
};

void add_options(CLI::App& app, Options& options, Words& words) {
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("axisd-nats"));
  app.add_option("--farm", words.farm, "NATS server and farm: nats://HOST[:PORT]/FARM or tls://HOST[:PORT]/FARM")
      ->type_name("URL");
  add_host(app, words.host);
  app.add_option("--socket", options.sockets,
                 "control socket of a daemon, may be given several times (default: all daemons of this machine)")
      ->type_name("PATH");
  app.add_flag("--read-only", options.read_only, "refuse whatever changes a unit");
  nats::add_server_options(app, words.security, "--farm");
  axisd::add_log_level(app, words.level);
  cli::add_completion(app, axisd::offer_log_levels);
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words given;
  CLI::App app{kDescription, "axisd-nats"};
  add_options(app, options, given);
  try {
    app.parse(count, words);
  } catch (const CLI::Success& asked) {
    app.exit(asked, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError{fmt::format("{} (see axisd-nats --help)", error.what())};
  }
  if (given.farm.empty()) throw UsageError{"--farm: expected the URL of a farm (see axisd-nats --help)"};
  options.farm = cli::valid(read_farm(given.farm, given.security));
  options.host = cli::valid(read_host(given.host));
  for (const std::string& path : options.sockets)
    if (const auto address = control::socket_address(path); !address)
      throw UsageError{"--socket: " + address.error()};
  options.log_level = cli::valid(axisd::read_log_level(given.level));
  return options;
}

}  // namespace farm
