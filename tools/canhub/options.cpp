#include "tools/canhub/options.hpp"

#include <array>
#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/nats_options/nats_options.hpp"
#include "can/userbus/bit_rate.hpp"
#include "can/userbus/protocol.hpp"
#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "text/number.hpp"
#include "version/version.hpp"

namespace canhub {

namespace {

constexpr const char* kDescription =
    "Serves a CAN bus in user space at a Unix socket, for programs that run under with-can and for axisd.";
using userbus::StartStatus;
constexpr std::array kExitRows{
    cli::ExitRow{static_cast<int>(StartStatus::Served),
                 "ended by a signal; with --on-demand: the path is served, by this hub or by one that was there"},
    cli::ExitRow{
        static_cast<int>(StartStatus::Failed),
        "failed, or the path is in use; with --status, --inject, --injected or --take-back: nobody serves it"},
    cli::ExitRow{static_cast<int>(StartStatus::Usage),
                 "wrong usage, a path that is too long and a fault that the bus cannot have included"},
    cli::ExitRow{static_cast<int>(StartStatus::InUse),
                 "with --on-demand: something that is no hub is at the path"},
    cli::ExitRow{static_cast<int>(StartStatus::Different),
                 "with --on-demand: a hub serves the path at another bit rate than --bitrate, or with another "
                 "time than --time"},
};

std::uint32_t bit_rate_of(const std::string& text) {
  std::uint32_t rate = 0;
  if (userbus::read_bit_rate(text.data(), text.size(), rate)) return rate;
  throw UsageError{fmt::format("--bitrate: expected {}, got \"{}\"", userbus::kBitRateRule, text)};
}

/// Where frames have to take time and nobody says how much (bit/s): the highest of ISO 11898-2.
constexpr std::uint32_t kBitRateOfToldTime = 1'000'000;

userbus::TimeWish time_of(const std::string& text) {
  userbus::TimeWish time{};
  if (userbus::read_time(text.data(), text.size(), time)) return time;
  throw UsageError{fmt::format("--time: expected {}, got \"{}\"", userbus::kTimeRule, text)};
}

/// Of a bus with a time of its own: nobody else has that, and frames last.
void check_time(Options& options, bool has_neighbours) {
  if (!options.time || options.time->mode == userbus::TimeMode::Real) return;
  if (has_neighbours)
    throw UsageError{
        "--bridge, --socketcand and --join need --time real: what they lead to has the machine's time"};
  if (options.time->mode == userbus::TimeMode::Scaled) return;
  if (options.bit_rate == 0U)
    throw UsageError{
        "--time virtual and stepped need a --bitrate above 0: only if frames take time does it go on"};
  if (!options.bit_rate) options.bit_rate = kBitRateOfToldTime;
}

std::string length_error(std::string_view what, std::size_t length) {
  if (length == 0) return fmt::format("{}: expected a path, got nothing", what);
  return fmt::format("{}: a path of {} bytes is too long for a socket, {} is the most", what, length,
                     userbus::kLongestPath);
}

userbus::Path path_of(const std::optional<std::string>& given) {
  userbus::Path path{};
  if (given) {
    if (!userbus::copy_path(given->c_str(), path)) throw UsageError{length_error("--path", given->size())};
  } else if (!userbus::default_path(path)) {
    throw UsageError{"the default bus ($CAN_BUS, or can-bus in $XDG_RUNTIME_DIR) has a path of more than " +
                     std::to_string(userbus::kLongestPath) + " bytes"};
  }
  return path;
}

TakeBack take_back_of(const std::string& text) {
  if (text == "all") return {};
  const auto number = text::integer<std::uint32_t>(text);
  if (!number)
    throw UsageError{fmt::format("--take-back: expected the number of a fault or all, got \"{}\"", text)};
  return {*number};
}

bus::Address bridge_of(const std::string& text, const userbus::Path& path) {
  auto address = bus::parse_address(text);
  if (!address) throw UsageError{"--bridge: " + address.error()};
  const auto* const other = std::get_if<bus::UserBusPath>(&address->place);
  if (other != nullptr && other->path == path.text)
    throw UsageError{fmt::format("--bridge: {} is the bus itself", text)};
  return *std::move(address);
}

/// What the command line says of the bus of several hosts.
struct JoinOptions {
  std::optional<std::string> url;
  nats::ServerOptions server;
};

void add_join_options(CLI::App& app, JoinOptions& join) {
  app.add_option("--join", join.url,
                 "the bus of several hosts that this one becomes a part of, over a NATS server")
      ->type_name("URL");
  nats::add_server_options(app, join.server, "--join");
}

std::optional<nats::Bus> bus_of(const JoinOptions& join) {
  if (!join.url) {
    if (join.server.are_given()) throw UsageError{"--credentials, --tls-... and --plain go with --join"};
    return std::nullopt;
  }
  auto bus = nats::parse_bus(*join.url);
  if (!bus) throw UsageError{fmt::format("--join: {}, got \"{}\"", bus.error(), *join.url)};
  if (auto done = nats::secure(bus->server, bus->host, join.server, "--join"); !done)
    throw UsageError{done.error()};
  return *std::move(bus);
}

/// What is not taken as it stands.
struct Words {
  std::optional<std::string> path, bit_rate, time, take_back;
  std::vector<std::string> bridges;
  JoinOptions join;

  /// Whether the bus is to be joined with others.
  [[nodiscard]] bool have_neighbours(const Options& options) const {
    return !bridges.empty() || !options.socketcand.empty() || join.url.has_value();
  }
};

void add_fault_options(CLI::App& app, Options& options, Words& words) {
  app.add_option("--with", options.with,
                 "a fault that the bus has from the start, in words or JSON; may be given several times")
      ->type_name("FAULT");
  app.add_option("--inject", options.inject,
                 "give a running hub a fault, \"bus.drop id=185 after=10 times=1\" or JSON, print its number, and "
                 "exit; may "
                 "be given several times")
      ->type_name("FAULT");
  app.add_flag("--injected", options.injected,
               "print the faults of a running hub and what they have hit, and exit");
  app.add_option("--take-back", words.take_back, "take back fault ID of a running hub, or all, and exit")
      ->type_name("ID");
  app.add_flag("--json", options.json, "print --injected as JSON");
}

/// Refuses what does not go together; @p has_neighbours: the bus is to be joined with others.
void check(const Options& options, bool has_neighbours) {
  if (options.is_about_faults() && (options.bit_rate || options.time || options.on_demand || options.status ||
                                    has_neighbours || !options.with.empty()))
    throw UsageError{
        "--inject, --injected and --take-back speak to a running hub: beside --path and --json they go with "
        "each other only"};
  if (options.json && !options.injected) throw UsageError{"--json goes with --injected"};
  if (options.on_demand && !options.with.empty())
    throw UsageError{"--on-demand does not go with --with, whose faults nobody would see refused"};
  if (options.on_demand && has_neighbours)
    throw UsageError{
        "--on-demand goes with none of --bridge, --socketcand and --join, whose failure nobody would see"};
}

void add_options(CLI::App& app, Options& options, Words& words) {
  app.add_option(
         "--path", words.path,
         "socket of the bus (default: $CAN_BUS, else $XDG_RUNTIME_DIR/can-bus, else /run/can-bus for root and "
         "/tmp/can-bus-UID/can-bus for others)")
      ->type_name("PATH");
  app.add_option(
         "--bitrate", words.bit_rate,
         "bit rate of the bus in bit/s (default: 0, frames take no time; 1000000 with --time virtual and stepped)")
      ->type_name("N");
  app.add_option("--time", words.time,
                 "whose time the bus has: real, scaled=K, virtual or stepped (default: real)")
      ->type_name("TIME");
  app.add_flag("--on-demand", options.on_demand,
               "return when the bus is served; the hub ends 1 s after its last member has left");
  app.add_option("--bridge", words.bridges, "another bus to be joined with this one; may be given several times")
      ->type_name("URL");
  app.add_option("--socketcand", options.socketcand, "serve clients of socketcand too")->type_name("HOST:PORT");
  add_join_options(app, words.join);
  app.add_flag("--status", options.status, "print what a running hub knows of its members, and exit");
  add_fault_options(app, options, words);
}

/// Throws UsageError.
void take(const Words& words, Options& options) {
  options.path = path_of(words.path);
  if (words.bit_rate) options.bit_rate = bit_rate_of(*words.bit_rate);
  if (words.take_back) options.take_back = take_back_of(*words.take_back);
  if (words.time) options.time = time_of(*words.time);
  const bool has_neighbours = words.have_neighbours(options);
  check(options, has_neighbours);
  check_time(options, has_neighbours);
  options.join = bus_of(words.join);
  for (const std::string& bridge : words.bridges) options.bridges.push_back(bridge_of(bridge, options.path));
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words given;
  CLI::App app{kDescription, "canhub"};
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("canhub"));
  add_options(app, options, given);
  cli::add_completion(app);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError{error.what()};
    app.exit(error);
    return std::nullopt;
  }
  take(given, options);
  return options;
}

}  // namespace canhub
