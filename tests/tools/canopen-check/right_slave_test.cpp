#include <gtest/gtest.h>

#include "eds/lint/lint.hpp"
#include "tests/tools/canopen-check/conformance_run.hpp"
#include "tools/canopen-check/checks/check_table.hpp"

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

}  // namespace
}  // namespace conformance_test
