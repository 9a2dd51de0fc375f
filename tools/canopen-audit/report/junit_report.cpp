#include <algorithm>

#include <fmt/format.h>

#include "audit/catalogue.hpp"
#include "tools/canopen-audit/report/report.hpp"
#include "tools/junit.hpp"

namespace audit_tool {
namespace {

std::string details_of(const std::vector<const Judged*>& findings, const Verdict& verdict) {
  std::string text;
  for (const Judged* const judged : findings) {
    const audit::Finding& finding = *judged->finding;
    text += fmt::format("node {}: {}{}\n", finding.node, finding.text,
                        judged->known.empty() ? "" : " (known: " + judged->known + ")");
    for (std::size_t i = 0; i < finding.evidence.size(); ++i)
      text += fmt::format("  {}  {}\n", frame_text(finding.evidence[i], verdict.info.begin),
                          frame_words(finding, i, verdict.auditor->network()));
  }
  return text;
}

junit::Case case_of(const audit::Rule& rule, const Verdict& verdict) {
  junit::Case result{.class_name = std::string{rule.id.substr(0, rule.id.find('.'))},
                     .name = std::string{rule.id}};
  std::vector<const Judged*> found, known;
  for (const Judged& judged : verdict.findings)
    if (judged.finding->rule == &rule) (judged.known.empty() ? found : known).push_back(&judged);
  result.output = details_of(known, verdict);
  if (found.empty()) return result;
  if (rule.severity == audit::Severity::Warning && !verdict.info.strict) {
    result.output += details_of(found, verdict);
    return result;
  }
  result.outcome = junit::Case::Outcome::Failed;
  result.message = fmt::format("{} ({} times)", rule.text, verdict.auditor->findings().count(rule) - known.size());
  result.type = std::string{rule.clause};
  result.text = details_of(found, verdict);
  return result;
}

/// What is known and was not found: the list is out of date.
junit::Suite unseen_suite(const Verdict& verdict) {
  junit::Suite suite{.name = "Known findings", .properties = {{"source", verdict.info.source}}};
  for (const std::string& unseen : verdict.unseen)
    suite.cases.push_back({.class_name = "known",
                           .name = unseen,
                           .outcome = junit::Case::Outcome::Failed,
                           .message = unseen,
                           .type = "known and not found"});
  return suite;
}

}  // namespace

std::string junit_of(const Verdict& verdict) {
  std::vector<junit::Suite> suites;
  for (const audit::RuleGroup& group : audit::rule_groups()) {
    junit::Suite suite{.name = std::string{group.title},
                       .properties = {{"version", verdict.info.version},
                                      {"source", verdict.info.source},
                                      {"frames", std::to_string(verdict.auditor->frames())}}};
    for (const audit::Rule* const rule : group.rules) suite.cases.push_back(case_of(*rule, verdict));
    suites.push_back(std::move(suite));
  }
  if (!verdict.unseen.empty()) suites.push_back(unseen_suite(verdict));
  return junit::xml_of("canopen-audit", suites);
}

}  // namespace audit_tool
