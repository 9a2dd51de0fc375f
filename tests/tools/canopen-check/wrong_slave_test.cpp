#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"

namespace conformance_test {

void PrintTo(const WrongSlave& slave, std::ostream* out) {
  *out << slave.name;
}

namespace {

std::vector<WrongSlave> all_wrong_slaves() {
  std::vector<WrongSlave> all;
  for (const auto slaves : {wrong_device_slaves, wrong_nmt_slaves, wrong_error_control_slaves, wrong_sdo_slaves,
                            wrong_sdo_block_slaves, wrong_sdo_server_slaves, wrong_pdo_slaves, wrong_sync_slaves,
                            wrong_emcy_slaves, wrong_robustness_slaves, wrong_lss_slaves, wrong_storage_slaves})
    for (WrongSlave& slave : slaves()) all.push_back(std::move(slave));
  return all;
}

class WrongSlaves : public testing::TestWithParam<WrongSlave> {};

TEST_P(WrongSlaves, AreFoundByTheChecksMeantAndByNoOther) {
  const conformance::RunReport report = run_checks(GetParam().defect);
  EXPECT_EQ(failed_checks(report), GetParam().found_by) << findings_of(report);
}

INSTANTIATE_TEST_SUITE_P(All, WrongSlaves, testing::ValuesIn(all_wrong_slaves()),
                         [](const testing::TestParamInfo<WrongSlave>& each) { return each.param.name; });

}  // namespace
}  // namespace conformance_test
