#include "tools/canopen-zoo/options.hpp"

#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "tools/canopen-zoo/residents.hpp"
#include "version/version.hpp"

namespace zoo {
namespace {

constexpr const char* kDescription =
    "Puts a CANopen slave on a bus that is wrong in one thing, for those who test their own masters and tools.";
constexpr std::array kExitRows{
    cli::ExitRow{kDone, "listed, or the EDS written, or ended by SIGTERM or SIGINT"},
    cli::ExitRow{kFailed, "the bus is not there or down"},
    cli::ExitRow{kUsage, "wrong usage, or a file that cannot be written"},
};
constexpr unsigned kHighestNode = 127;

/// What the options hold as text until they are judged.
struct Words {
  std::string list{}, name{}, interface {};
  unsigned node = 0;
  bool json = false, right = false;
};

void offer_names(cli::Command& program) {
  const std::vector<WrongSlave> all = residents();
  std::vector<std::string_view> names;
  names.reserve(all.size());
  for (const WrongSlave& slave : all) names.emplace_back(slave.name);
  cli::offer_choices(program, "--run", names);
}

void add_options(CLI::App& app, Options& options, Words& words) {
  cli::add_completion(app, offer_names);
  app.add_flag("--list{text}", words.list,
               "print every slave, what is wrong with it and which checks of canopen-check find it, and exit; "
               "--list=markdown prints a page")
      ->check(CLI::IsMember({"text", "markdown"}));
  app.add_flag("--json", words.json, "with --list: as JSON");
  auto* const run = app.add_option("--run", words.name, "the slave of this name of --list")->type_name("NAME");
  app.add_flag("--right", words.right, "the one that does everything right, for comparison")->excludes(run);
  app.add_option("--interface", words.interface, "CAN interface, or the URL of a bus as axisd takes it")
      ->type_name("IF");
  app.add_option("--node", words.node, "node-ID of the slave, 1 to 127")
      ->check(CLI::Range(1U, kHighestNode))
      ->type_name("N");
  app.add_option("--eds", options.eds,
                 "write the EDS of the slave first, - to standard output; without --interface that is all")
      ->type_name("FILE");
}

void judge(Options& options, const Words& words) {
  if (!words.list.empty()) {
    options.list = words.json ? ListForm::Json : words.list == "markdown" ? ListForm::Markdown : ListForm::Text;
    return;
  }
  if (words.json) throw UsageError{"--json: needs --list"};
  if (words.name.empty() && !words.right) throw UsageError{"expected --list, --run NAME or --right"};
  tl::expected<WrongSlave, std::string> slave = find_resident(words.right ? kRight : words.name);
  if (!slave) throw UsageError{"--run: " + slave.error()};
  options.slave = *std::move(slave);
  if (words.interface.empty()) {
    if (options.eds.empty()) throw UsageError{"--interface: needed, unless --eds asks for the EDS alone"};
    return;
  }
  if (words.node == 0) throw UsageError{"--node: needed, a node-ID 1 to 127"};
  options.node_id = static_cast<std::uint8_t>(words.node);
  tl::expected<bus::Address, std::string> address = bus::parse_address(words.interface);
  if (!address)
    throw UsageError{fmt::format("--interface: expected {}, got \"{}\"", address.error(), words.interface)};
  options.interface = *std::move(address);
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words held;
  CLI::App app{kDescription, "canopen-zoo"};
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("canopen-zoo"));
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

}  // namespace zoo
