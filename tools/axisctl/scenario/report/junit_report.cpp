#include <fmt/format.h>

#include "tools/axisctl/scenario/report/report.hpp"
#include "tools/junit.hpp"
#include "version/version.hpp"

namespace scenario {
namespace {

using Test = junit::Case;

Test case_of(const StepResult& result, const Scenario& scenario) {
  Test test{.class_name = "scenario." + scenario.name,
            .name = fmt::format("{:02} {}", result.step->number, result.step->text),
            .seconds = result.took_s};
  if (result.kind == StepResult::Kind::Passed) return test;
  test.outcome = result.kind == StepResult::Kind::Failed ? Test::Outcome::Failed : Test::Outcome::Skipped;
  test.message = result.text.empty() ? "not run" : result.text;
  test.type = "step";
  return test;
}

}  // namespace

std::string junit_of(const std::vector<Ran>& runs) {
  std::vector<junit::Suite> suites;
  for (const auto& [scenario, result] : runs) {
    junit::Suite suite{.name = scenario.name,
                       .properties = {{"tool", version::line("axisctl")},
                                      {"file", scenario.file},
                                      {"seed", std::to_string(scenario.seed)},
                                      {"bus", result.bus}}};
    for (const StepResult& step : result.steps) suite.cases.push_back(case_of(step, scenario));
    if (!result.problem.empty() || suite.cases.empty())
      suite.cases.push_back({.class_name = "scenario." + scenario.name,
                             .name = "the run as a whole",
                             .outcome = Test::Outcome::Error,
                             .message = result.problem.empty() ? "nothing was run" : result.problem,
                             .type = "run"});
    if (!result.passed) suite.cases.back().output = text_of(scenario, result);
    suites.push_back(std::move(suite));
  }
  return junit::xml_of("axisctl run", suites);
}

}  // namespace scenario
