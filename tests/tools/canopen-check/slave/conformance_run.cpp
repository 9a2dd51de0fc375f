#include "tests/tools/canopen-check/slave/conformance_run.hpp"

#include "eds/document/document.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

namespace zoo {

void PrintTo(const WrongSlave& slave, std::ostream* out) {
  *out << slave.name;
}

}  // namespace zoo

namespace conformance_test {

using conformance::CheckResult;
using conformance::Outcome;

conformance::Settings full_settings() {
  return {.node_id = 5, .mode = conformance::Mode::Full, .allow_store = true, .allow_motion = true};
}

namespace {

eds::Description description_of(const Defect& defect, std::uint8_t node_id) {
  std::string text = eds_of(objects_of(defect));
  defect.eds(text);
  eds::Findings findings{"right.eds"};
  const eds::Document document = eds::read_document(text, findings);
  const eds::DataSheet sheet = eds::read_data_sheet(document, findings);
  eds::Description description;
  description.add(sheet, node_id);
  return description;
}

conformance::RunReport run_on(Station& station, const Defect& defect, std::string_view only,
                              const conformance::Settings& settings) {
  SimulatedWire wire;
  wire.add(station);
  const eds::Description description = description_of(defect, settings.node_id);
  std::vector<const conformance::Check*> checks = conformance::all_checks();
  std::erase_if(checks, [&](const conformance::Check* check) { return !check->id.starts_with(only); });
  conformance::Deviations deviations;
  return conformance::Runner{wire, description, settings, deviations}.run(checks, {});
}

}  // namespace

conformance::RunReport run_checks(const Defect& defect, std::string_view only,
                                  const conformance::Settings& settings) {
  Slave slave{defect};
  return run_on(slave, defect, only, settings);
}

conformance::RunReport run_checks(const Defect& defect, const Slowness& slowness, std::string_view only) {
  Slave slave{defect};
  SlowStation slow{slave, slowness};
  return run_on(slow, defect, only, full_settings());
}

eds::Description right_description() {
  return description_of({}, full_settings().node_id);
}

std::set<std::string> failed_checks(const conformance::RunReport& report) {
  std::set<std::string> ids;
  for (const CheckResult& result : report.results)
    if (!result.findings.empty()) ids.emplace(result.check->id);
  return ids;
}

std::string findings_of(const conformance::RunReport& report) {
  std::string text = report.problem.empty() ? "" : report.problem + "\n";
  for (const CheckResult& result : report.results) {
    const std::string id{result.check->id};
    for (const conformance::Finding& finding : result.findings)
      text += id + " " + conformance::to_text(finding.subject) + ": expected " + finding.expected + ", found " +
              finding.found + "\n";
    if (result.outcome == Outcome::Broken) text += id + ": " + result.reason + "\n";
    for (const std::string& note : result.notes)
      if (note.starts_with("not restored")) text += id + ": " + note + "\n";
  }
  for (const std::string& line : report.not_restored) text += "not restored: " + line + "\n";
  return text;
}

}  // namespace conformance_test
