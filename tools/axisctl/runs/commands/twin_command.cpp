#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "os/regular_file.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/runs/commands/yardstick_wish.hpp"
#include "tools/axisctl/runs/fidelity/report.hpp"
#include "tools/axisctl/runs/twin/twin.hpp"
#include "tools/axisctl/scenario/run/bench.hpp"

namespace axisctl {
namespace {

/// What the words of twin say.
struct TwinWish {
  YardstickWish common{};
  std::string config{}, report{};
  bool keeps_files = false;
};
constexpr std::size_t kLargestConfiguration = std::size_t{4} << 20U;

Expected<nlohmann::json> read_configuration(const std::string& path) {
  if (path.empty()) return nlohmann::json::object();
  const auto text = os::read_regular_file(path, kLargestConfiguration);
  if (!text)
    return fail(ExitStatus::NotThere,
                fmt::format("--config: {}: cannot be read: {}", path, text.error().reason()));
  auto config = nlohmann::json::parse(*text, nullptr, false);
  if (!config.is_object())
    return fail(ExitStatus::Usage, fmt::format("--config: {}: expected a JSON object, as axisd --config", path));
  return config;
}

Expected<runs::TwinPlan> plan_of(const TwinWish& wish, const PlayedLog& log) {
  if (log.nodes.size() != 1)
    return fail(ExitStatus::Usage,
                fmt::format("{}: the nodes {} have answered in it: --node says which one is meant",
                            wish.common.log, fmt::join(log.nodes, ", ")));
  auto config = read_configuration(wish.config);
  if (!config) return tl::unexpected{config.error()};
  runs::TwinPlan plan{.log = wish.common.log,
                      .interface = wish.common.interface,
                      .node = log.nodes.front(),
                      .config = *std::move(config),
                      .keeps_files = wish.keeps_files};
  if (wish.common.bit_rate) plan.bit_rate = *wish.common.bit_rate;
  return plan;
}

Expected<void> play_twin(const Settings& settings, const TwinWish& wish) {
  if (auto done = expect_no_farm(settings, "twin", "it has a unit and a bus of its own, on this machine"); !done)
    return done;
  const auto log = prepare(wish.common);
  if (!log) return tl::unexpected{log.error()};
  const auto plan = plan_of(wish, *log);
  if (!plan) return tl::unexpected{plan.error()};
  scenario::take_signals();
  const auto result = runs::play_to_twin(*plan, log->yardstick);
  if (!result) return tl::unexpected{result.error()};
  if (!result->folder.empty()) std::cerr << "axisctl: files are kept in " << result->folder << '\n';
  nlohmann::json report{{"log", wish.common.log},
                        {"node", plan->node},
                        {"replay", json_of(result->figures)},
                        {"fidelity", json_of(result->fidelity)},
                        {"remarks", log->remarks}};
  const std::string text =
      fmt::format("{}, played to axisd as node {}: {}\n", wish.common.log, plan->node, text_of(result->figures)) +
      text_of(result->fidelity, wish.common.most);
  if (!wish.report.empty())
    if (auto written = write_whole(wish.report, settings.json ? report.dump(2) + '\n' : text); !written)
      return written;
  if (auto printed = print_report(settings, report, text); !printed) return printed;
  const std::uint64_t unknown = result->fidelity.unknown();
  if (unknown == 0) return {};
  return fail(ExitStatus::Failed, fmt::format("{} differences from {}", unknown, wish.common.log));
}

}  // namespace

void add_twin(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "twin", "Play the log of a real unit to axisd, and tell how true that is to it");
  const auto wish = std::make_shared<TwinWish>();
  add_yardstick(sub, wish->common);
  sub.add_option("--config", wish->config, "Configuration of axisd, as its --config")->type_name("FILE");
  sub.add_option("--report", wish->report, "Write the report to FILE, with --json as JSON")->type_name("FILE");
  sub.add_flag("--keep", wish->keeps_files, "Keep the files of the run: configuration, logs, state");
  sub.callback([&run, wish] { run = [wish](const Settings& settings) { return play_twin(settings, *wish); }; });
}

}  // namespace axisctl
