#include <fmt/format.h>

#include "tools/canopen-check/report/report.hpp"
#include "tools/junit.hpp"

namespace conformance {
namespace {

using Test = junit::Case;

/// The first findings of a check; all of them are in its details.
std::string message_of(const CheckResult& result) {
  constexpr int kMost = 3;
  std::string text;
  int count = 0;
  for (const Finding& finding : result.findings) {
    if (!finding.deviation.empty() || ++count > kMost) continue;
    const std::string subject = to_text(finding.subject);
    text += fmt::format("{}{}{}expected {}, found {}", text.empty() ? "" : "; ", subject,
                        subject.empty() ? "" : ": ", finding.expected, finding.found);
  }
  if (count > kMost) text += fmt::format("; and {} more", count - kMost);
  return text;
}

Test case_of(const CheckResult& result, const RunInfo& info) {
  const Check& check = *result.check;
  Test test{.class_name = fmt::format("canopen-check.{}", name_of(check.group).word),
            .name = fmt::format("{}: {}", check.id, check.name),
            .seconds = seconds(result.time)};
  test.output = details_of(result, info);
  test.message = result.reason;
  if (result.outcome == Outcome::Failed) {
    test.outcome = Test::Outcome::Failed;
    test.message = message_of(result);
    test.type = "finding";
    test.text = check.clause;
  } else if (result.outcome == Outcome::Broken) {
    test.outcome = Test::Outcome::Error;
    test.type = "broken";
  } else if (result.outcome == Outcome::Skipped) {
    test.outcome = Test::Outcome::Skipped;
  }
  return test;
}

}  // namespace

std::string junit_of(const RunReport& report, const RunInfo& info) {
  std::vector<junit::Suite> suites;
  for (const GroupName& group : kGroups) {
    junit::Suite suite{.name = std::string{group.title},
                       .properties = {{"tool", "canopen-check " + info.version},
                                      {"eds", info.eds},
                                      {"device", info.device},
                                      {"interface", info.interface},
                                      {"node", fmt::format("{}", info.node_id)},
                                      {"mode", info.mode}}};
    for (const CheckResult& result : report.results)
      if (result.check->group == group.group) suite.cases.push_back(case_of(result, info));
    if (!suite.cases.empty()) suites.push_back(std::move(suite));
  }
  return junit::xml_of("canopen-check", suites);
}

}  // namespace conformance
