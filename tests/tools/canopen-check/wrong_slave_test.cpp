#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"

namespace conformance_test {
namespace {

class WrongSlaves : public testing::TestWithParam<WrongSlave> {};

TEST_P(WrongSlaves, AreFoundByTheChecksMeantAndByNoOther) {
  const conformance::RunReport report = run_checks(GetParam().defect);
  EXPECT_EQ(failed_checks(report), GetParam().found_by) << findings_of(report);
}

INSTANTIATE_TEST_SUITE_P(All, WrongSlaves, testing::ValuesIn(wrong_slaves()),
                         [](const testing::TestParamInfo<WrongSlave>& each) { return each.param.name; });

}  // namespace
}  // namespace conformance_test
