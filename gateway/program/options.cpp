#include "gateway/program/options.hpp"

#include <algorithm>
#include <array>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/nats_options/nats_options.hpp"
#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "control/socket_name.hpp"
#include "farm/options/farm_option.hpp"
#include "service_options/log_level_option.hpp"
#include "version/version.hpp"

namespace gateway {
namespace {

constexpr const char* kDescription =
    "Serves the units of all axisd of this machine, or of a farm, over HTTP: REST, server-sent events and "
    "metrics.";
constexpr std::array kExitRows{
    cli::ExitRow{kDone, "ended by SIGTERM or SIGINT"},
    cli::ExitRow{kFailure, "failed: an address is taken, the token file cannot be read"},
    cli::ExitRow{kUsage, "wrong usage"}};

Authority listen_of(const std::string& text) {
  auto authority = parse_authority(text);
  if (authority && authority->port && is_ip_address(authority->host)) return *std::move(authority);
  throw UsageError{
      fmt::format("--listen: expected ADDRESS:PORT such as {} or [::1]:8402, got \"{}\"", kDefaultListen, text)};
}

std::string host_of(const std::string& text) {
  auto authority = parse_authority(text);
  if (authority && !authority->port) return std::move(authority->host);
  throw UsageError{fmt::format("--allow-host: expected a name or an address without a port, got \"{}\"", text)};
}

std::string origin_of(const std::string& text) {
  if (const auto origin = parse_origin(text)) return origin->text();
  throw UsageError{fmt::format("--allow-origin: expected http://HOST[:PORT] or https://, got \"{}\"", text)};
}

/// The words that stand behind options, as they were given.
struct Words {
  std::vector<std::string> listen;
  std::vector<std::string> hosts;
  std::vector<std::string> origins;
  std::string level = axisd::kDefaultLogLevel;
  std::optional<std::string> farm;
  nats::ServerOptions server;
};

void add_options(CLI::App& app, Options& options, Words& words) {
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("axisd-http"));
  app.add_option(
         "--listen", words.listen,
         fmt::format("IP address and port to serve at, may be given several times (default: {})", kDefaultListen))
      ->type_name("ADDRESS:PORT");
  app.add_option("--allow-host", words.hosts,
                 "a further name or address by which clients may call this server, may be given several times")
      ->type_name("NAME");
  app.add_option("--allow-origin", words.origins,
                 "web pages of this origin may use the server too (CORS), may be given several times")
      ->type_name("URL");
  app.add_option("--token-file", options.token_file,
                 "file of the token that writing needs, made if it is missing (default: token in "
                 "$STATE_DIRECTORY, else $XDG_STATE_HOME/axisd-http or ~/.local/state/axisd-http)")
      ->type_name("FILE");
  app.add_flag("--read-only", options.read_only, "refuse whatever changes a unit, with a token too");
  app.add_option("--socket", options.sockets,
                 "control socket of a daemon, may be given several times (default: all daemons of this machine)")
      ->type_name("PATH");
  app.add_option(
         "--farm", words.farm,
         "farm whose units are served in place of those of this machine, nats://HOST[:PORT]/FARM or tls://")
      ->type_name("URL");
  nats::add_server_options(app, words.server, "--farm");
  app.add_option("--page", options.page, "folder of the web page (default: share/axisd/web beside the program)")
      ->type_name("FOLDER");
  axisd::add_log_level(app, words.level);
  cli::add_completion(app, axisd::offer_log_levels);
}

std::optional<farm::FarmUrl> farm_of(const Words& given, const Options& options) {
  if (!given.farm) {
    if (given.server.are_given()) throw UsageError{"--credentials, --tls-... and --plain go with --farm"};
    return std::nullopt;
  }
  if (!options.sockets.empty()) throw UsageError{"--farm does not go with --socket"};
  return cli::valid(farm::read_farm(*given.farm, given.server));
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words given;
  CLI::App app{kDescription, "axisd-http"};
  add_options(app, options, given);
  try {
    app.parse(count, words);
  } catch (const CLI::Success& asked) {
    app.exit(asked, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError{fmt::format("{} (see axisd-http --help)", error.what())};
  }
  if (given.listen.empty()) given.listen.emplace_back(kDefaultListen);
  std::ranges::transform(given.listen, std::back_inserter(options.listen), listen_of);
  std::ranges::transform(given.hosts, std::back_inserter(options.allow_hosts), host_of);
  std::ranges::transform(given.origins, std::back_inserter(options.allow_origins), origin_of);
  for (const std::string& path : options.sockets)
    if (const auto address = control::socket_address(path); !address)
      throw UsageError{"--socket: " + address.error()};
  options.farm = farm_of(given, options);
  options.log_level = cli::valid(axisd::read_log_level(given.level));
  return options;
}

}  // namespace gateway
