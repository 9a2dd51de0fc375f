#include "meaning/words.hpp"
#include "tools/axisctl/scenario/report/report.hpp"
#include "tools/canopen-check/core/sdo_client.hpp"

namespace scenario {
namespace {

using nlohmann::json;

const char* word_of(StepResult::Kind kind) {
  switch (kind) {
    case StepResult::Kind::Passed:
      return "passed";
    case StepResult::Kind::Failed:
      return "failed";
    case StepResult::Kind::NotRun:
      break;
  }
  return "not run";
}

json json_of(const StepResult& result) {
  json value{{"step", result.step->number}, {"what", result.step->text}, {"outcome", word_of(result.kind)},
             {"t", result.begin_s},         {"seconds", result.took_s},  {"text", result.text}};
  if (result.step->keys.contains("name")) value["name"] = result.step->keys["name"];
  return value;
}

}  // namespace

json json_of(const Scenario& scenario, const RunResult& result) {
  json steps = json::array(), frames = json::array();
  for (const StepResult& step : result.steps) steps.push_back(json_of(step));
  for (const conformance::TimedFrame& frame : result.frames)
    frames.push_back({{"t", std::chrono::duration<double>(frame.time.time_since_epoch()).count()},
                      {"sent", frame.sent},
                      {"frame", conformance::to_text(frame.frame)},
                      {"service", meaning::service_of(frame.frame)}});
  return {{"scenario", scenario.name}, {"title", scenario.title}, {"file", scenario.file},
          {"seed", scenario.seed},     {"bus", result.bus},       {"passed", result.passed},
          {"problem", result.problem}, {"steps", steps},          {"faults", result.faults},
          {"frames", frames},          {"notes", result.notes},   {"seconds", result.seconds}};
}

}  // namespace scenario
