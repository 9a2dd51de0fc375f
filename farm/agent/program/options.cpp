#include "farm/agent/program/options.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "can/nats_options/nats_options.hpp"
#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "control/socket_name.hpp"
#include "farm/documents/agent_beat.hpp"
#include "farm/naming/unit_name.hpp"
#include "farm/options/farm_option.hpp"
#include "farm/options/host_option.hpp"
#include "service_options/log_level_option.hpp"
#include "text/name.hpp"
#include "text/number.hpp"
#include "version/version.hpp"

namespace farm::agent {
namespace {

constexpr const char* kDescription =
    "The agent of a host on a farm: starts, changes and stops there the units that are wanted.";
constexpr std::string_view kDefaultCapacity = "100";
constexpr std::array kExitRows{
    cli::ExitRow{kDone,
                 "ended by SIGTERM, SIGINT or SIGHUP: units go on, or were given away with --drain-on-stop"},
    cli::ExitRow{kFailure,
                 "failed: a folder cannot be used, or another agent does; with --drain-on-stop: units are "
                 "left that were not given away"},
    cli::ExitRow{kUsage, "wrong usage"}};

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The first of several folders, as systemd gives them.
std::string first_of(const std::string& folders) {
  return folders.substr(0, folders.find(':'));
}

/// Below the folder where clients look for control sockets.
std::string default_runtime() {
  if (const std::string own = environment("RUNTIME_DIRECTORY"); !own.empty()) return first_of(own);
  const bool is_private = !environment("XDG_RUNTIME_DIR").empty() || ::geteuid() == 0;
  if (!is_private) throw UsageError{"--runtime-directory: expected a folder, for $XDG_RUNTIME_DIR is not set"};
  return control::runtime_directory() + "/axisd/agent";
}

std::string default_state() {
  if (const std::string own = environment("STATE_DIRECTORY"); !own.empty()) return first_of(own);
  if (const std::string user = environment("XDG_STATE_HOME"); !user.empty()) return user + "/axisd-agent";
  if (const std::string home = environment("HOME"); !home.empty()) return home + "/.local/state/axisd-agent";
  throw UsageError{"--state-directory: expected a folder, for $HOME is not set"};
}

/// @p given, or @p otherwise(), as a path that programs in other folders understand.
template <class Otherwise>
std::string folder_of(const std::string& given, Otherwise otherwise) {
  return std::filesystem::absolute(given.empty() ? otherwise() : given).lexically_normal().string();
}

std::uint32_t capacity_of(const std::string& text) {
  const auto number = text::integer<std::uint32_t>(text);
  if (number && *number >= 1 && *number <= kGreatestCapacity) return *number;
  throw UsageError{
      fmt::format("--capacity: expected a number of units, 1 to {}, got \"{}\"", kGreatestCapacity, text)};
}

std::string name_of(const char* option, const std::string& text) {
  if (is_name(text)) return text;
  throw UsageError{fmt::format("{}: expected a name of {}, got \"{}\"", option, text::kNameForm, text)};
}

/// The words that stand behind options, as they were given.
struct Words {
  std::string farm;
  std::string host;
  std::string capacity{kDefaultCapacity};
  std::vector<std::string> buses;
  std::string runtime;
  std::string state;
  std::string level = axisd::kDefaultLogLevel;
  nats::ServerOptions security;
};

FarmUrl farm_of(const Words& given) {
  if (given.farm.empty()) throw UsageError{"--farm: expected the URL of a farm (see axisd-agent --help)"};
  return cli::valid(read_farm(given.farm, given.security));
}

/// For programs that run in another folder.
std::vector<std::string> security_of(const nats::ServerOptions& given) {
  std::vector<std::string> words;
  const auto add = [&words](const char* option, const std::string& file) {
    if (!file.empty()) words.insert(words.end(), {option, std::filesystem::absolute(file).string()});
  };
  add("--credentials", given.security.credentials);
  add("--tls-ca", given.security.certificates);
  add("--tls-cert", given.security.certificate);
  add("--tls-key", given.security.key);
  if (given.plain) words.emplace_back("--plain");
  return words;
}

void add_options(CLI::App& app, Options& options, Words& words) {
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("axisd-agent"));
  app.add_option("--farm", words.farm, "NATS server and farm: nats://HOST[:PORT]/FARM or tls://HOST[:PORT]/FARM")
      ->type_name("URL");
  add_host(app, words.host);
  app.add_option("--capacity", words.capacity,
                 fmt::format("units that are a fair share of this host; others get units in proportion to theirs "
                             "(default: {})",
                             kDefaultCapacity))
      ->type_name("N");
  app.add_option("--bus", words.buses,
                 "take units of this bus alone, may be given several times (default: those of all buses)")
      ->type_name("NAME");
  app.add_option("--runtime-directory", words.runtime,
                 "folder of sockets and configurations (default: $RUNTIME_DIRECTORY, else axisd/agent in "
                 "$XDG_RUNTIME_DIR, or in /run for root)")
      ->type_name("DIR");
  app.add_option("--state-directory", words.state,
                 "folder of what units save (default: $STATE_DIRECTORY, else axisd-agent in $XDG_STATE_HOME or "
                 "~/.local/state)")
      ->type_name("DIR");
  app.add_option("--control-group", options.control_group,
                 "group whose members may use the control sockets of the units (default: none)")
      ->type_name("GROUP")
      ->take_last();
  app.add_flag("--drain-on-stop", options.drain_on_stop,
               "give all units away before ending (default: they go on without an agent)");
  nats::add_server_options(app, words.security);
  axisd::add_log_level(app, words.level);
  cli::add_completion(app, axisd::offer_log_levels);
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words given;
  CLI::App app{kDescription, "axisd-agent"};
  add_options(app, options, given);
  try {
    app.parse(count, words);
  } catch (const CLI::Success& asked) {
    app.exit(asked, std::cout, std::cerr);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError{fmt::format("{} (see axisd-agent --help)", error.what())};
  }
  options.farm = farm_of(given);
  options.security = security_of(given.security);
  options.host = cli::valid(read_host(given.host));
  options.capacity = capacity_of(given.capacity);
  for (const std::string& bus : given.buses) options.buses.insert(name_of("--bus", bus));
  options.runtime = folder_of(given.runtime, default_runtime);
  options.state = folder_of(given.state, default_state);
  options.log_level = cli::valid(axisd::read_log_level(given.level));
  options.log_level_name = given.level;
  return options;
}

}  // namespace farm::agent
