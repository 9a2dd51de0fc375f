#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"

/// Slaves that are right, and slow: what the checks wait for comes late, and is no finding.
namespace conformance_test {
namespace {

using std::chrono::milliseconds;

struct SlowSlave {
  const char* name;
  Slowness slowness;
  bool is_drive = false;
};

void PrintTo(const SlowSlave& slave, std::ostream* out) {
  *out << slave.name;
}

const std::vector<SlowSlave> kSlowSlaves{
    {"InEverythingBy2Ms", {milliseconds{2}, milliseconds{2}, {}}},
    {"InEverythingBy15Ms", {milliseconds{15}, milliseconds{15}, {}}},
    {"InEverythingBy20MsAsADrive", {milliseconds{20}, milliseconds{20}, {}}, true},
    {"InHearingAllButSdo", {milliseconds{1}, milliseconds{10}, {}}},
    {"InHearingAllButSdoTwiceAsMuch", {milliseconds{1}, milliseconds{20}, {}}},
    {"InSpeakingAllButSdo", {{}, {}, milliseconds{10}}},
    {"InSpeakingAllButSdoTwiceAsMuch", {{}, {}, milliseconds{20}}},
    {"InHearingAndSpeaking", {milliseconds{1}, milliseconds{8}, milliseconds{8}}},
    {"AndTakesOneRequestAtATime", {milliseconds{2}, milliseconds{2}, {}, true}},
};

class SlowSlaves : public testing::TestWithParam<SlowSlave> {};

TEST_P(SlowSlaves, HaveNoFinding) {
  Defect right;
  if (GetParam().is_drive) right.drive = DriveFlaws{};
  EXPECT_EQ(findings_of(run_checks(right, GetParam().slowness)), "");
}

INSTANTIATE_TEST_SUITE_P(All, SlowSlaves, testing::ValuesIn(kSlowSlaves),
                         [](const testing::TestParamInfo<SlowSlave>& each) { return each.param.name; });

}  // namespace
}  // namespace conformance_test
