#include <map>

#include <gtest/gtest.h>

#include "eds/lint/lint.hpp"
#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

namespace conformance_test {
namespace {

TEST(RightSlave, HasAnEdsWithoutAFinding) {
  const eds::Findings findings = eds::lint(eds_of(right_objects()), "right.eds");
  for (const eds::Finding& finding : findings.all()) ADD_FAILURE() << eds::to_text(finding);
}

TEST(RightSlave, HasNoFinding) {
  const conformance::RunReport report = run_checks({});
  EXPECT_TRUE(report.reached);
  EXPECT_EQ(findings_of(report), "");
  EXPECT_EQ(report.results.size(), conformance::all_checks().size());
}

TEST(RightSlave, HasNoFindingWithLssToo) {
  const conformance::RunReport report = run_checks(right_lss(), "lss.");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_EQ(report.count(conformance::Outcome::Passed), report.results.size());
}

/// Ids of checks that are skipped, with their reasons.
std::map<std::string, std::string> skipped(const conformance::RunReport& report) {
  std::map<std::string, std::string> reasons;
  for (const conformance::CheckResult& result : report.results)
    if (result.outcome == conformance::Outcome::Skipped) reasons.emplace(result.check->id, result.reason);
  return reasons;
}

TEST(RightSlave, SkipsOnlyWhatItDoesNotOffer) {
  for (const auto& [id, reason] : skipped(run_checks({})))
    EXPECT_TRUE(id.starts_with("lss.") || id.starts_with("drive.") || id == "pdo.cob-id-limits" ||
                reason.find("produces no SYNC") != std::string::npos)
        << id << ": " << reason;
}

TEST(RightDrive, HasAnEdsWithoutAFinding) {
  const eds::Findings findings = eds::lint(eds_of(objects_of({.drive = DriveFlaws{}})), "right.eds");
  for (const eds::Finding& finding : findings.all()) ADD_FAILURE() << eds::to_text(finding);
}

TEST(RightDrive, HasNoFinding) {
  EXPECT_EQ(findings_of(run_checks({.drive = DriveFlaws{}})), "");
}

TEST(RightDrive, HasEveryCheckOfDrives) {
  const conformance::RunReport report = run_checks({.drive = DriveFlaws{}}, "drive.");
  EXPECT_TRUE(skipped(report).empty()) << skipped(report).begin()->first << ": "
                                       << skipped(report).begin()->second;
  EXPECT_EQ(report.count(conformance::Outcome::Passed), report.results.size());
}

TEST(RightDrive, StandsStillWithoutAllowMotion) {
  conformance::Settings settings = full_settings();
  settings.allow_motion = false;
  const conformance::RunReport report = run_checks({.drive = DriveFlaws{}}, "drive.", settings);
  EXPECT_EQ(findings_of(report), "");
  for (const conformance::CheckResult& result : report.results)
    EXPECT_EQ(result.outcome == conformance::Outcome::Skipped, result.check->moves) << result.check->id;
}

}  // namespace
}  // namespace conformance_test
