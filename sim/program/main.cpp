#include <exception>
#include <iostream>
#include <sstream>

#include <fmt/format.h>

#include "sim/plan/shrink.hpp"
#include "sim/program/options.hpp"
#include "sim/program/report.hpp"
#include "tools/user_file.hpp"

namespace {

using namespace sim;

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw UsageError{"standard output cannot be written"};
}

WorldPlan plan_in(const std::string& path) {
  auto plan = read_plan(tools::read_user_file(path));
  if (!plan) throw UsageError{path + ": " + plan.error()};
  return *std::move(plan);
}

/// Nothing is logged below the least severe level that there is.
axisd::Log log_of(const Options& options) {
  constexpr axisd::LogLevel kNothing{0};
  return axisd::Log{options.log_level.value_or(kNothing), "axisd-sim"};
}

/// The plan of a smaller world that breaks the same rule.
std::string shrunk(const WorldPlan& plan, std::string_view rule, const axisd::Log& log) {
  const WorldPlan small = shrink(plan, [&](const WorldPlan& smaller) {
    const Outcome outcome = run_world(smaller, log);
    return outcome.breach && outcome.breach->rule == rule;
  });
  return breach_text(small, run_world(small, log), "--plan FILE, which is this:") + json_of(small).dump(2) + "\n";
}

/// Whether all is well with the world of @p plan.
bool run_one(const WorldPlan& plan, const Options& options, const axisd::Log& log, Sums& sums) {
  std::ostringstream frames;
  const Outcome outcome = run_world(plan, log, options.log.empty() ? nullptr : &frames);
  tools::write_user_file(options.log, frames.str());
  sums.add(plan, outcome);
  if (outcome.breach) {
    print(breach_text(plan, outcome,
                      options.plan.empty() ? fmt::format("--seed {}", plan.seed) : "--plan " + options.plan));
    if (options.shrinks) print(shrunk(plan, outcome.breach->rule, log));
    return false;
  }
  if (!options.repeats || run_world(plan, log).digest == outcome.digest) return true;
  print(fmt::format("seed {}: a second run has other frames\n", plan.seed));
  ++sums.broken;
  return false;
}

int run(const Options& options) {
  if (options.lists) return print(list_text()), kHolds;
  if (options.prints_plan) return print(json_of(draw_plan(options.first)).dump(2) + "\n"), kHolds;
  tools::expect_writable(options.json);
  tools::expect_writable(options.log);
  const axisd::Log log = log_of(options);
  Sums sums;
  bool holds = true;
  if (!options.plan.empty()) {
    holds = run_one(plan_in(options.plan), options, log, sums);
  } else {
    for (std::uint64_t i = 0; i < options.seeds; ++i)
      holds &= run_one(draw_plan(options.first + i), options, log, sums);
  }
  print(text_of(sums));
  if (!options.json.empty()) tools::write_user_file(options.json, json_of(sums).dump(2) + "\n");
  return holds ? kHolds : kBroken;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::optional<Options> options = parse_command_line(argc, argv);
    return options ? run(*options) : kHolds;
  } catch (const std::exception& error) {
    std::cerr << "axisd-sim: " << error.what() << '\n';
    return kUsage;
  }
}
