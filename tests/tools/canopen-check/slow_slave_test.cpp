#include <algorithm>

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

std::set<std::string> skipped_checks(const conformance::RunReport& report) {
  std::set<std::string> ids;
  for (const conformance::CheckResult& each : report.results)
    if (each.outcome == conformance::Outcome::Skipped) ids.emplace(each.check->id);
  return ids;
}

TEST_P(SlowSlaves, HaveNoFindingAndAreTestedAsQuickOnesAre) {
  Defect right;
  if (GetParam().is_drive) right.drive = DriveFlaws{};
  const conformance::RunReport report = run_checks(right, GetParam().slowness);
  EXPECT_EQ(findings_of(report), "");
  EXPECT_EQ(skipped_checks(report), skipped_checks(run_checks(right)));
}

INSTANTIATE_TEST_SUITE_P(All, SlowSlaves, testing::ValuesIn(kSlowSlaves),
                         [](const testing::TestParamInfo<SlowSlave>& each) { return each.param.name; });

void remove_consumer(std::vector<canopen::EntryDescription>& table) {
  std::erase_if(table, [](const auto& entry) { return entry.index == 0x1016; });
}

TEST(SlowSlaves, WithoutConsumerWhoseLifeTimeIsLookedAtEvery20MsHaveNoFinding) {
  const Defect without_consumer{.table = remove_consumer, .eds = [](std::string& eds) {
                                  std::vector<canopen::EntryDescription> table = right_objects();
                                  remove_consumer(table);
                                  eds = eds_of(table);
                                }};
  const conformance::RunReport report = run_checks(without_consumer, {.tick = milliseconds{20}}, "error-control.");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_FALSE(skipped_checks(report).contains("error-control.error-behaviour"));
}

/// True if @p slave is wrong in a service of which nothing is known from its SDO answers: what is wrong comes late
/// if it is slow there.
bool shows_late(const WrongSlave& slave) {
  static const std::set<std::string> checks{"emcy.disabled",
                                            "error-control.consumer-begins",
                                            "error-control.life-guarding-begins",
                                            "error-control.error-behaviour",
                                            "error-control.guarding-other-node",
                                            "error-control.heartbeat-ends",
                                            "nmt.boot-up-once",
                                            "nmt.no-tpdo-in-pre-operational",
                                            "nmt.no-tpdo-in-stopped",
                                            "nmt.no-rpdo-in-pre-operational",
                                            "nmt.no-rpdo-in-stopped",
                                            "pdo.event",
                                            "pdo.event-timer-off",
                                            "pdo.remote-request-forbidden",
                                            "pdo.remote-request-present",
                                            "pdo.remote-request-state",
                                            "pdo.rpdo-synchronous",
                                            "pdo.rpdo-too-short",
                                            "lss.waiting",
                                            "lss.switch-selective-others"};
  return std::ranges::any_of(slave.found_by, [](const std::string& id) { return checks.contains(id); });
}

std::vector<WrongSlave> late_wrong_slaves() {
  std::vector<WrongSlave> slaves = wrong_slaves();
  std::erase_if(slaves, [](const WrongSlave& slave) { return !shows_late(slave); });
  return slaves;
}

class LateWrongSlaves : public testing::TestWithParam<WrongSlave> {};

TEST_P(LateWrongSlaves, AreFoundAndNothingElse) {
  const conformance::RunReport report =
      run_checks(GetParam().defect, {.sdo = {}, .others = {}, .out = milliseconds{20}});
  EXPECT_EQ(failed_checks(report), GetParam().found_by) << findings_of(report);
}

INSTANTIATE_TEST_SUITE_P(All, LateWrongSlaves, testing::ValuesIn(late_wrong_slaves()),
                         [](const testing::TestParamInfo<WrongSlave>& each) { return each.param.name; });

}  // namespace
}  // namespace conformance_test
