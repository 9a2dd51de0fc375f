#include "tools/canopen-check/options.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <ranges>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "tools/canopen-check/checks/objects/static_checks.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "version/version.hpp"

namespace conformance {
namespace {

constexpr const char* kDescription =
    "Tests a CANopen slave against CiA 301 and its EDS. What is written is read before and restored afterwards; a "
    "drive is\nenabled with --allow-motion only.";
constexpr std::array kExitRows{
    cli::ExitRow{kClean, "no check failed; known deviations are no failure"},
    cli::ExitRow{kFound,
                 "a check failed, the run ended before its last check, or something could not be restored"},
    cli::ExitRow{kUsage, "wrong usage, or a file that cannot be read, used or written"},
    cli::ExitRow{kNotReached, "the bus or the node could not be reached, or every check was skipped"},
};
constexpr unsigned kHighestNode = 127;

/// What the options hold as text until they are judged.
struct Words {
  std::string interface {};
  unsigned node = 0;
  unsigned timeout = 1000, boot_limit = 10'000;
  bool is_static = false, read_only = false, full = false, no_reset = false;
  std::string list{};
};

void add_options(CLI::App& app, Options& options, Words& words) {
  cli::add_completion(app);
  app.add_option("--interface", words.interface, "CAN interface, or the URL of a bus as axisd takes it")
      ->type_name("IF");
  app.add_option("--node", words.node, "node-ID of the slave, 1 to 127")
      ->check(CLI::Range(1U, kHighestNode))
      ->type_name("N");
  app.add_option("--eds", options.eds_files, "EDS of the slave, or several that describe parts of it")
      ->type_name("FILE");
  app.add_option("--only", options.only, "checks of this group, or those whose id begins so")
      ->delimiter(',')
      ->type_name("GROUP");
  app.add_option("--skip", options.settings.skip, "leave out this check, those whose id begins so, or a group")
      ->delimiter(',')
      ->type_name("CHECK");
  app.add_option("--deviations", options.deviations, "JSON list of deviations that are known")->type_name("FILE");
  app.add_option("--junit", options.junit, "write a JUnit XML report")->type_name("FILE");
  app.add_option("--json", options.json, "write a JSON report")->type_name("FILE");
  auto* const modes = app.add_option_group("Mode", "How far it may go");
  modes->add_flag("--static", words.is_static, "the EDS alone; needs no bus");
  modes->add_flag("--read-only", words.read_only, "changes nothing on the node");
  modes->add_flag("--full", words.full, "writes, restores and resets (default)");
  modes->require_option(0, 1);
  app.add_flag("--allow-store", options.settings.allow_store, "may store and load parameters (1010h, 1011h)");
  app.add_flag("--allow-motion", options.settings.allow_motion,
               "may enable and move a drive of CiA 402: up to half a revolution, slowly");
  app.add_flag("--no-reset", words.no_reset,
               "sends no NMT command that resets the node; checks that need one are skipped");
  app.add_option("--timeout", words.timeout, "how long an SDO answer may take (default: 1000)")
      ->check(CLI::Range(10U, 60'000U))
      ->type_name("MS");
  app.add_option("--boot-limit", words.boot_limit, "how long a boot-up may take (default: 10000)")
      ->check(CLI::Range(100U, 600'000U))
      ->type_name("MS");
  app.add_option("--seed", options.settings.seed, "of random frames (default: 1)")->type_name("N");
  app.add_flag("--list{text}", words.list, "print every check and exit; --list=markdown prints rows of a table")
      ->check(CLI::IsMember({"text", "markdown"}));
  app.add_flag("--verbose", options.verbose, "print what was measured, for the checks that passed too");
}

/// Throws UsageError unless each of @p words, which @p option brought, names a check.
void expect_checks(const char* option, const std::vector<std::string>& words) {
  const auto known = [](const std::string& word) {
    const auto named = [&](const Check& check) { return is_named(check, word); };
    return std::ranges::any_of(static_checks(), named) ||
           std::ranges::any_of(all_checks(), [&](const Check* check) { return named(*check); });
  };
  for (const std::string& word : words) {
    if (known(word)) continue;
    std::string groups;
    for (const GroupName& group : kGroups) groups += (groups.empty() ? "" : ", ") + std::string{group.word};
    throw UsageError{fmt::format("{}: expected a group ({}) or the beginning of an id (see --list), got \"{}\"",
                                 option, groups, word)};
  }
}

void judge(Options& options, const Words& words) {
  options.settings.mode = words.is_static ? Mode::Static : words.read_only ? Mode::ReadOnly : Mode::Full;
  options.settings.node_id = static_cast<std::uint8_t>(words.node);
  options.settings.patience = std::chrono::milliseconds{words.timeout};
  options.settings.boot_up_limit = std::chrono::milliseconds{words.boot_limit};
  options.settings.allow_reset = !words.no_reset;
  options.list = !words.list.empty();
  options.markdown = words.list == "markdown";
  expect_checks("--only", options.only);
  expect_checks("--skip", options.settings.skip);
  if (options.list) return;
  if (options.settings.mode == Mode::Static) {
    if (options.eds_files.empty()) throw UsageError{"--static: needs --eds FILE"};
    options.settings.node_id = std::max<std::uint8_t>(options.settings.node_id, 1);
    return;
  }
  if (words.interface.empty()) throw UsageError{"--interface: needed, unless --static asks for the EDS alone"};
  if (words.node == 0) throw UsageError{"--node: needed, a node-ID 1 to 127"};
  tl::expected<bus::Address, std::string> address = bus::parse_address(words.interface);
  if (!address)
    throw UsageError{fmt::format("--interface: expected {}, got \"{}\"", address.error(), words.interface)};
  options.interface = std::move(*address);
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words held;
  CLI::App app{kDescription, "canopen-check"};
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("canopen-check"));
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

bool is_wanted(const Options& options, const Check& check) {
  return options.only.empty() ||
         std::ranges::any_of(options.only, [&](const std::string& word) { return is_named(check, word); });
}

}  // namespace conformance
