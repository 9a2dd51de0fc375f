#include "tools/canhub/options.hpp"

#include <iostream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/userbus/bit_rate.hpp"
#include "cli/completion.hpp"

namespace canhub {

namespace {

constexpr const char* kDescription =
    "Serves a CAN bus in user space at a Unix socket, for programs that run under with-can and for axisd.";
constexpr const char* kFooter =
    "Exit status: 0 done, 1 failed, 2 wrong usage; with --on-demand also 3 the path is used by something else,\n"
    "4 the bus is served at another bit rate; with --status 1 nobody serves the bus.";

std::uint32_t bit_rate_of(const std::string& text) {
  std::uint32_t rate = 0;
  if (userbus::read_bit_rate(text.data(), text.size(), rate)) return rate;
  throw UsageError{fmt::format("--bitrate: expected {}, got \"{}\"", userbus::kBitRateRule, text)};
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

bus::Address bridge_of(const std::string& text, const userbus::Path& path) {
  auto address = bus::parse_address(text);
  if (!address) throw UsageError{"--bridge: " + address.error()};
  const auto* const other = std::get_if<bus::UserBusPath>(&address->place);
  if (other != nullptr && other->path == path.text)
    throw UsageError{fmt::format("--bridge: {} is the bus itself", text)};
  return *std::move(address);
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  CLI::App app{kDescription, "canhub"};
  std::optional<std::string> path;
  std::optional<std::string> bit_rate;
  std::vector<std::string> bridges;
  app.footer(kFooter);
  app.set_version_flag("--version", "canhub " AXISD_VERSION);
  app.add_option(
         "--path", path,
         "socket of the bus (default: $CAN_BUS, else $XDG_RUNTIME_DIR/can-bus, else /run/can-bus for root and "
         "/tmp/can-bus-UID/can-bus for others)")
      ->type_name("PATH");
  app.add_option("--bitrate", bit_rate, "bit rate of the bus in bit/s (default: 0, frames take no time)")
      ->type_name("N");
  app.add_flag("--on-demand", options.on_demand,
               "return when the bus is served; the hub ends 1 s after its last member has left");
  app.add_option("--bridge", bridges, "another bus to be joined with this one; may be given several times")
      ->type_name("URL");
  app.add_option("--socketcand", options.socketcand, "serve clients of socketcand too")->type_name("HOST:PORT");
  app.add_flag("--status", options.status, "print what a running hub knows of its members, and exit");
  cli::add_completion(app);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError{error.what()};
    app.exit(error);
    return std::nullopt;
  }
  options.path = path_of(path);
  if (bit_rate) options.bit_rate = bit_rate_of(*bit_rate);
  if (options.on_demand && (!bridges.empty() || !options.socketcand.empty()))
    throw UsageError{"--on-demand goes with neither --bridge nor --socketcand, whose failure nobody would see"};
  for (const std::string& bridge : bridges) options.bridges.push_back(bridge_of(bridge, options.path));
  return options;
}

}  // namespace canhub
