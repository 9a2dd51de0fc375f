#include "sim/program/options.hpp"

#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "version/version.hpp"

namespace sim {
namespace {

constexpr const char* kDescription =
    "Runs whole worlds of one seed each: a bus with units and masters, disks and power, and what goes wrong with "
    "them, in a time of its own, and judges after every event whether the invariants hold.\n"
    "The same seed gives the same world, bit for bit.";
constexpr std::array kExitRows{
    cli::ExitRow{kHolds, "every invariant held in every world"},
    cli::ExitRow{kBroken, "an invariant was broken, or a world did not repeat itself"},
    cli::ExitRow{kUsage, "wrong usage, or a file that cannot be read, used or written"},
};
constexpr std::uint64_t kMostSeeds = 1'000'000'000;

/// What the options hold as text until they are judged.
struct Words {
  std::uint64_t seed = 0;
  std::string log_level{};
};

void add_options(CLI::App& app, Options& options, Words& words) {
  cli::add_completion(app);
  app.add_option("--seed", words.seed, "the world of this seed alone")->type_name("N");
  app.add_option("--seeds", options.seeds, "so many worlds, one behind the other")
      ->check(CLI::Range(std::uint64_t{1}, kMostSeeds))
      ->type_name("N");
  app.add_option("--first", options.first, "the first seed (default: 1)")->type_name("N");
  app.add_option("--plan", options.plan, "the world of a plan, as --print-plan prints it")->type_name("FILE");
  app.add_option("--json", options.json, "write a JSON report")->type_name("FILE");
  app.add_option("--log", options.log, "write all frames, as candump -L prints them")->type_name("FILE");
  app.add_flag("--shrink", options.shrinks, "of a world that fails, look for a smaller one and print its plan");
  app.add_flag("--print-plan", options.prints_plan, "print the plan of the seed and exit");
  app.add_flag("--repeat", options.repeats,
               "run each world twice: both have to have the same frames at the same times");
  app.add_flag("--list", options.lists, "print the invariants and the kinds of faults and exit");
  app.add_option("--log-level", words.log_level, "what units log goes to standard error (default: nothing)")
      ->type_name("LEVEL");
}

void judge(Options& options, const CLI::App& app, const Words& words) {
  if (app.count("--seed") != 0) {
    if (app.count("--seeds") + app.count("--first") != 0)
      throw UsageError{"--seed: is one, expected neither --seeds nor --first beside it"};
    options.first = words.seed;
  }
  if (!options.plan.empty() && app.count("--seed") + app.count("--seeds") + app.count("--first") != 0)
    throw UsageError{"--plan: says the whole world, expected no seed beside it"};
  if (!options.plan.empty() && options.prints_plan)
    throw UsageError{"--print-plan: prints that of a seed, expected no --plan beside it"};
  if (!options.log.empty() && options.seeds > 1)
    throw UsageError{"--log: holds one world, expected --seed or --plan beside it"};
  if (words.log_level.empty()) return;
  options.log_level = axisd::level_named(words.log_level);
  if (!options.log_level)
    throw UsageError{fmt::format("--log-level: expected {}, got \"{}\"", axisd::kLogLevelNames, words.log_level)};
}

}  // namespace

std::optional<Options> parse_command_line(int count, const char* const* words) {
  Options options;
  Words held;
  CLI::App app{kDescription, "axisd-sim"};
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("axisd-sim"));
  add_options(app, options, held);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError{error.what()};
    (void)app.exit(error);
    return std::nullopt;
  }
  judge(options, app, held);
  return options;
}

}  // namespace sim
