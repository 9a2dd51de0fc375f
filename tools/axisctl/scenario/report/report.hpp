#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tools/axisctl/scenario/run/run.hpp"

namespace scenario {

/// The report for people: a line a step, and what there is to know of a failure.
[[nodiscard]] std::string text_of(const Scenario& scenario, const RunResult& result);
/// The same for programs; docs/reference/scenarios.md says what is in it.
[[nodiscard]] nlohmann::json json_of(const Scenario& scenario, const RunResult& result);

/// Everything that was kept of a run, as a page: the report for programs has `t_s` of each step there, the time of
/// the first unit. Takes the units of @p result.
[[nodiscard]] axisctl::Page page_of(const Scenario& scenario, RunResult& result);

/// A scenario with what came of it.
struct Ran {
  Scenario scenario;
  RunResult result;
};
/// All of @p runs as JUnit XML: a testsuite a scenario, a testcase a step.
[[nodiscard]] std::string junit_of(const std::vector<Ran>& runs);

}  // namespace scenario
