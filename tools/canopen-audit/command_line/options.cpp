#include "tools/canopen-audit/command_line/options.hpp"

#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/userbus/bit_rate.hpp"
#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "text/number.hpp"
#include "version/version.hpp"

namespace audit_tool {
namespace {

constexpr const char* kDescription =
    "Judges CANopen masters by what they do on a bus, or have done in a log, and shows each mistake with its "
    "frames.\n"
    "It sends nothing.";
constexpr std::array kExitRows{
    cli::ExitRow{kClean, "no error was found, and with --strict no warning; known findings do not count"},
    cli::ExitRow{kFound, "an error was found, or something that is known was not found"},
    cli::ExitRow{kUsage, "wrong usage, or a file that cannot be read, used or written"},
    cli::ExitRow{kNotReached, "there was no frame, or the bus could not be reached or went down"},
};
constexpr unsigned kHighestNode = 127;
constexpr const char* kSheetRule = "NODE:FILE, the node-ID (1 to 127) and its EDS";

/// What the options hold as text until they are judged.
struct Words {
  std::string interface {};
  std::vector<std::string> sheets{};
  unsigned seconds = 0;
  std::string list{};
};

void add_options(CLI::App& app, Options& options, Words& words) {
  cli::add_completion(app);
  app.add_option("LOG", options.log, "log of candump, what candump has printed, or a recording; else --interface");
  app.add_option("--interface", words.interface, "CAN interface, or the URL of a bus as axisd takes it: live")
      ->type_name("IF");
  app.add_option("--of", options.of, "the interface that is meant in a log of several")->type_name("IF");
  app.add_option("--eds", words.sheets, "EDS or DCF of a node; one a node, several times")
      ->type_name("NODE:FILE")
      ->allow_extra_args(false);
  app.add_option("--bit-rate", options.bit_rate, "of the bus in bit/s, for its load")
      ->check(CLI::Range(userbus::kLowestBitRate, userbus::kHighestBitRate))
      ->type_name("N");
  app.add_option("--seconds", words.seconds, "live: how long it listens (default: until Ctrl-C)")
      ->check(CLI::Range(1U, 1'000'000U))
      ->type_name("N");
  app.add_option("--known", options.known, "JSON list of findings that are known")->type_name("FILE");
  app.add_option("--junit", options.junit, "write a JUnit XML report")->type_name("FILE");
  app.add_option("--json", options.json, "write a JSON report")->type_name("FILE");
  app.add_flag("--strict", options.strict, "a warning is a failure, too");
  app.add_flag("--time-lines", options.time_lines, "print what has happened to each node");
  app.add_flag("--list{text}", words.list, "print every rule and exit; --list=markdown prints their page")
      ->check(CLI::IsMember({"text", "markdown"}));
}

Sheet read_sheet(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto node = text::integer<unsigned>(std::string_view{text}.substr(0, colon));
  if (colon == std::string::npos || !node || *node < 1 || *node > kHighestNode || colon + 1 == text.size())
    throw UsageError{fmt::format("--eds: expected {}, got \"{}\"", kSheetRule, text)};
  return {static_cast<std::uint8_t>(*node), text.substr(colon + 1)};
}

void add_sheet(Options& options, Sheet sheet) {
  for (const Sheet& other : options.sheets)
    if (other.node == sheet.node)
      throw UsageError{fmt::format("--eds: expected one a node, got two of node {}", sheet.node)};
  options.sheets.push_back(std::move(sheet));
}

void judge(Options& options, const Words& words) {
  options.list = !words.list.empty();
  options.markdown = words.list == "markdown";
  if (options.list) return;
  for (const std::string& text : words.sheets) add_sheet(options, read_sheet(text));
  if (words.seconds != 0) options.duration = std::chrono::seconds{words.seconds};
  if (words.interface.empty() == options.log.empty()) throw UsageError{"expected either LOG or --interface"};
  if (words.interface.empty()) {
    if (options.duration) throw UsageError{"--seconds: is for --interface, a log is read to its end"};
    return;
  }
  if (!options.of.empty()) throw UsageError{"--of: is for a log, --interface has one interface"};
  tl::expected<bus::Address, std::string> address = bus::parse_address(words.interface);
  if (!address)
    throw UsageError{fmt::format("--interface: expected {}, got \"{}\"", address.error(), words.interface)};
  options.interface = std::move(*address);
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words held;
  CLI::App app{kDescription, "canopen-audit"};
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("canopen-audit"));
  add_options(app, options, held);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError{error.what()};
    (void)app.exit(error);
    return std::nullopt;
  }
  judge(options, held);
  return options;
}

}  // namespace audit_tool
