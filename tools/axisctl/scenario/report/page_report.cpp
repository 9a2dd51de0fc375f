#include <algorithm>
#include <utility>

#include "tools/axisctl/scenario/report/report.hpp"

namespace scenario {
namespace {

using nlohmann::json;

/// @p moment (ns since 1970) as time of a unit with @p recordings, since it was switched on (s): one that was
/// switched off and on has several beginnings. Null if there was none before.
json time_of_unit(const std::vector<axisctl::Recording>& recordings, std::chrono::nanoseconds moment) {
  std::int64_t start = 0;
  for (const axisctl::Recording& recording : recordings)
    if (recording.start() <= moment.count()) start = std::max(start, recording.start());
  if (start == 0) return nullptr;
  return std::chrono::duration<double>{moment - std::chrono::nanoseconds{start}}.count();
}

json step_of(const StepResult& step, const RunResult& result) {
  const auto begin =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>{step.begin_s});
  const bool has_begun = step.kind != StepResult::Kind::NotRun || !step.text.empty();
  json value{{"number", step.step->number},
             {"text", step.step->text},
             {"t_s", nullptr},
             {"seconds", step.took_s},
             {"passed", step.kind == StepResult::Kind::Passed},
             {"run", has_begun},
             {"remark", step.text}};
  if (has_begun && !result.units.empty())
    value["t_s"] = time_of_unit(result.units.front().recordings, result.begin + begin);
  for (const char* const key : {"name", "about"})
    if (step.step->keys.contains(key)) value[key] = step.step->keys[key];
  return value;
}

}  // namespace

axisctl::Page page_of(const Scenario& scenario, RunResult& result) {
  json report = json_of(scenario, result);
  report["steps"] = json::array();
  for (const StepResult& step : result.steps) report["steps"].push_back(step_of(step, result));
  return {.title = scenario.title,
          .made_at = axisctl::time_of_making(),
          .verdict = axisctl::PageVerdict{result.passed, text_of(scenario, result), std::move(report)},
          .units = std::move(result.units)};
}

}  // namespace scenario
