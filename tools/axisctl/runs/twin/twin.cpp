#include "tools/axisctl/runs/twin/twin.hpp"

#include <fmt/format.h>

#include "can/port/address.hpp"
#include "tools/axisctl/runs/fidelity/judge.hpp"
#include "tools/axisctl/scenario/run/stations.hpp"

namespace runs {
namespace {

scenario::Scenario scenario_of(const TwinPlan& plan) {
  scenario::Scenario scenario;
  scenario.name = "twin";
  scenario.bit_rate = plan.bit_rate;
  scenario::UnitPlan unit{.name = "unit", .node_id = plan.node, .config = plan.config};
  unit.config["node_id"] = plan.node;
  scenario.units.push_back(std::move(unit));
  return scenario;
}

Expected<TwinResult> play(scenario::Stations& stations, const TwinPlan& plan, const Yardstick& yardstick) {
  scenario::Bench bench{bus::open(*bus::parse_address(stations.bus())), stations.time()};
  if (auto started = stations.start_units(bench); !started) return fail(ExitStatus::NotReachable, started.error());
  auto log = LogReader::open(plan.log, plan.interface);
  if (!log) return tl::unexpected{log.error()};
  Nodes units;
  units.set(plan.node);
  Replay replay{
      bench, units, meaning::CobIds{yardstick.description}, {.patience = plan.patience, .keeps_courses = true}};
  std::optional<std::string> lost;
  bench.on_look([&] {
    lost = stations.find_lost();
    return !lost;
  });
  const auto played = replay.play(**log);
  bench.on_look({});
  if (lost) return fail(ExitStatus::CutOff, *lost);
  if (!played) return tl::unexpected{played.error()};
  return TwinResult{.figures = replay.figures(), .fidelity = judge(replay.log(), replay.run(), yardstick)};
}

}  // namespace

Expected<TwinResult> play_to_twin(const TwinPlan& plan, const Yardstick& yardstick) {
  const scenario::Scenario scenario = scenario_of(plan);
  const auto workshop = scenario::Workshop::open(plan.keeps_files);
  if (!workshop) return fail(ExitStatus::Failed, workshop.error());
  try {
    scenario::Stations stations{scenario, *workshop, {.address = "", .time = "virtual"}, scenario::Recorded::No};
    if (auto checked = stations.check_units(); !checked) {
      constexpr std::string_view kPlace = "/units/0/config";
      const std::string& error = checked.error();
      return fail(ExitStatus::Usage,
                  "--config: " + (error.starts_with(kPlace) ? error.substr(kPlace.size()) : error));
    }
    if (auto started = stations.start_bus(); !started) return fail(ExitStatus::NotReachable, started.error());
    auto result = play(stations, plan, yardstick);
    if (result && plan.keeps_files) result->folder = workshop->folder();
    return result;
  } catch (const bus::OpenError& error) {
    return fail(ExitStatus::NotReachable, error.what());
  }
}

}  // namespace runs
