#pragma once

#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/test_bus.hpp"
#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace e2e {

/// How each check of a run of canopen-check has ended.
using Outcomes = std::map<std::string, std::string>;

/// The checks that ended with that outcome.
inline std::set<std::string> checks_with(const Outcomes& outcomes, const std::string& outcome) {
  std::set<std::string> checks;
  for (const auto& [check, ended] : outcomes)
    if (ended == outcome) checks.insert(check);
  return checks;
}

/// What the command line @p words of canopen-check finds; the report has to come.
inline Outcomes run_conformance(std::vector<std::string> words) {
  const fakes::TemporaryDirectory folder;
  words.insert(words.end(), {"--json", folder.path("report.json")});
  const fakes::Finished run = fakes::run_program(words, bus_environment());
  EXPECT_TRUE(run.status == 0 || run.status == 1) << run.status << run.output << run.errors;
  std::ifstream file{folder.path("report.json")};
  const nlohmann::json report = nlohmann::json::parse(file, nullptr, false);
  Outcomes outcomes;
  if (report.is_discarded()) return outcomes;
  for (const nlohmann::json& result : report.at("results")) outcomes[result.at("id")] = result.at("outcome");
  const bool finds = !checks_with(outcomes, "failed").empty();
  EXPECT_EQ(run.status, finds ? 1 : 0) << run.output << run.errors;
  return outcomes;
}

/// The same; but a check that fails and is none of those @p expected to is run again, and its last outcome counts.
/// For many checks wait a tenth of a second for an answer, and a busy machine may let the node stand still for
/// longer: a finding is what comes each time.
inline Outcomes conformance(const std::vector<std::string>& words, const std::set<std::string>& expected = {}) {
  constexpr int kMostRepetitions = 4;
  Outcomes outcomes = run_conformance(words);
  for (int i = 0; i < kMostRepetitions; ++i) {
    std::string doubtful;
    for (const std::string& check : checks_with(outcomes, "failed"))
      if (!expected.contains(check)) doubtful += (doubtful.empty() ? "" : ",") + check;
    if (doubtful.empty()) break;
    std::vector<std::string> again = words;
    again.insert(again.end(), {"--only", doubtful});
    for (const auto& [check, outcome] : run_conformance(again)) outcomes[check] = outcome;
  }
  return outcomes;
}

}  // namespace e2e
