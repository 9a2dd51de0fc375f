#include "tools/axisctl/scenario/run/recording_plan.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "record/format.hpp"
#include "tools/axisctl/page/unit_recorder.hpp"

namespace scenario {
namespace {

using nlohmann::json;

/// Most that the recordings of all units take together (MB): they fit into a page.
constexpr double kMostMB = 40.0;

/// Whether @p keys, of a step or of a condition, mean the unit of @p plan.
bool means(const json& keys, const UnitPlan& plan, const Scenario& scenario) {
  return keys.value("unit", json(scenario.units.front().name)) == plan.name;
}

/// Whether a step begins or ends recordings of the unit of @p plan itself.
bool has_own_recordings(const Scenario& scenario, const UnitPlan& plan) {
  return std::ranges::any_of(scenario.steps, [&](const Step& step) {
    return means(step.keys, plan, scenario) && step.keys.value("call", "").starts_with("record.");
  });
}

/// Adds the signals of the unit of @p plan that @p keys and what is below name.
void add_named(const json& keys, const UnitPlan& plan, const Scenario& scenario,
               std::vector<std::string>& signals) {
  for (const auto& [key, value] : keys.items()) {
    if (value.is_object()) add_named(value, plan, scenario, signals);
    if (key != "signal" || !value.is_string() || !means(keys, plan, scenario)) continue;
    if (std::ranges::count(signals, value.get<std::string>()) == 0) signals.push_back(value);
  }
}

std::vector<std::string> signals_of(const Scenario& scenario, const UnitPlan& plan, Signals which) {
  const json axes = plan.config.value("axes", json{});
  const auto of_axes = axisctl::default_signals(axes.is_array() ? axes.size() : 1);
  std::vector<std::string> named;
  if (which == Signals::All)
    for (const Step& step : scenario.steps) add_named(step.keys, plan, scenario, named);
  std::erase_if(named, [&](const std::string& signal) { return std::ranges::count(of_axes, signal) != 0; });
  named.resize(std::min(named.size(), record::kMostSignals));
  std::vector<std::string> all{of_axes};
  all.resize(std::min(all.size(), record::kMostSignals - named.size()));
  all.insert(all.end(), named.begin(), named.end());
  return all;
}

}  // namespace

json with_recording(const Scenario& scenario, const UnitPlan& plan, Signals signals) {
  json config = plan.config;
  if (config.contains("record") || has_own_recordings(scenario, plan)) return config;
  config["record"] = {{"name", "run"},
                      {"signals", signals_of(scenario, plan, signals)},
                      {"max_MB", std::max(1.0, kMostMB / static_cast<double>(scenario.units.size()))}};
  return config;
}

}  // namespace scenario
