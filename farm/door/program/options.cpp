#include "farm/door/program/options.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include "can/nats_options/nats_options.hpp"
#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "control/socket_name.hpp"
#include "farm/naming/unit_name.hpp"
#include "text/name.hpp"
#include "version/version.hpp"

namespace farm {

namespace {

using axisd::LogLevel;

constexpr const char* kDescription = "The door of a host on a farm: its units are reached over a NATS server.";
constexpr std::array kExitRows{cli::ExitRow{kDone, "ended by SIGTERM or SIGINT"},
                               cli::ExitRow{kFailure, "failed: the kernel gives no descriptor or thread"},
                               cli::ExitRow{kUsage, "wrong usage"}};

LogLevel log_level_of(const std::string& name) {
  if (const auto level = axisd::level_named(name)) return *level;
  throw UsageError{fmt::format("--log-level: expected {}, got \"{}\"", axisd::kLogLevelNames, name)};
}

FarmUrl farm_of(const std::string& text, const nats::ServerOptions& security) {
  auto url = parse_farm_url(text);
  if (!url) throw UsageError{fmt::format("--farm: {}, got \"{}\"", url.error(), text)};
  if (const auto secured = nats::secure(url->server, url->host, security, "--farm"); !secured)
    throw UsageError{secured.error()};
  return *std::move(url);
}

std::string name_of_machine() {
  std::array<char, HOST_NAME_MAX + 1> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "host";
  return name_from(name.data());
}

std::string host_of(const std::string& text) {
  if (text.empty()) return name_of_machine();
  if (is_name(text)) return text;
  throw UsageError{fmt::format("--host: expected a name of {}, got \"{}\"", text::kNameForm, text)};
}

void complete_levels(cli::Command& program) {
  std::array<std::string_view, axisd::kLogLevels.size()> names{};
  std::ranges::transform(axisd::kLogLevels, names.begin(), &axisd::LogLevelRow::name);
  cli::offer_choices(program, "--log-level", names);
}

/// The words that stand behind options, as they were given.
struct Words {
  std::string farm;
  std::string host;
  std::string level = "info";
  nats::ServerOptions security;
};

void add_options(CLI::App& app, Options& options, Words& words) {
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("axisd-nats"));
  app.add_option("--farm", words.farm, "NATS server and farm: nats://HOST[:PORT]/FARM or tls://HOST[:PORT]/FARM")
      ->type_name("URL");
  app.add_option("--host", words.host, "name of this host on the farm (default: that of the machine)")
      ->type_name("NAME");
  app.add_option("--socket", options.sockets,
                 "control socket of a daemon, may be given several times (default: all daemons of this machine)")
      ->type_name("PATH");
  app.add_flag("--read-only", options.read_only, "refuse whatever changes a unit");
  nats::add_server_options(app, words.security, "--farm");
  app.add_option("--log-level", words.level, "error, warning, notice, info or debug (default: info)")
      ->type_name("LEVEL");
  cli::add_completion(app, complete_levels);
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
  options.farm = farm_of(given.farm, given.security);
  options.host = host_of(given.host);
  for (const std::string& path : options.sockets)
    if (const auto address = control::socket_address(path); !address)
      throw UsageError{"--socket: " + address.error()};
  options.log_level = log_level_of(given.level);
  return options;
}

}  // namespace farm
