#include "tools/canopen-check/checks/objects/static_checks.hpp"

#include <algorithm>
#include <deque>

#include <fmt/format.h>

#include "eds/lint/check_table.hpp"
#include "eds/sheet/section_name.hpp"

namespace conformance {
namespace {

struct Table {
  std::deque<std::string> ids;
  std::vector<Check> checks;
};

Table make_table() {
  Table table;
  for (const eds::Check& check : eds::kChecks) {
    const std::string& id = table.ids.emplace_back(fmt::format("static.{}", check.id));
    table.checks.push_back(
        {.id = id, .name = check.rule, .clause = "CiA 306", .group = Group::Static, .mode = Mode::Static});
  }
  return table;
}

Subject subject_of(const eds::Finding& finding) {
  const eds::SectionName name = eds::parse_section_name(finding.section);
  if (name.kind == eds::SectionKind::SubObject) return {name.index, name.sub_index};
  if (name.kind == eds::SectionKind::Object) return {.index = name.index};
  return {};
}

std::string place_of(const eds::Finding& finding) {
  return fmt::format("{}:{}: [{}] {}", finding.file, finding.line, finding.section, finding.key);
}

}  // namespace

std::span<const Check> static_checks() {
  static const Table table = make_table();
  return table.checks;
}

std::vector<CheckResult> judge_files(std::span<const eds::Finding> findings) {
  std::vector<CheckResult> results;
  for (const Check& check : static_checks()) results.push_back({.check = &check});
  for (const eds::Finding& finding : findings) {
    const auto result = std::ranges::find(results, fmt::format("static.{}", finding.check),
                                          [](const CheckResult& each) { return each.check->id; });
    if (result == results.end()) continue;
    if (finding.severity == eds::Severity::Warning) {
      result->notes.push_back("warning: " + eds::to_text(finding));
      continue;
    }
    result->outcome = Outcome::Failed;
    result->findings.push_back({.subject = subject_of(finding),
                                .expected = finding.expected,
                                .found = fmt::format("{} ({})", finding.found, place_of(finding))});
  }
  return results;
}

}  // namespace conformance
