#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tools/canopen-zoo/slave/defects.hpp"

/// How long a run takes, in simulated time: what the checks wait for is shared, or known already.
namespace conformance_test {
namespace {

using canopen::Frame;
using conformance::CheckResult;
using conformance::RunReport;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// What the checks of @p report took whose ids begin with @p begin.
canopen::Duration time_of(const RunReport& report, std::string_view begin) {
  canopen::Duration time{};
  for (const CheckResult& each : report.results)
    if (each.check->id.starts_with(begin)) time += each.time;
  return time;
}

TEST(Times, OfAQuickSlaveAreShort) {
  const RunReport report = run_checks({});
  EXPECT_LT(report.time, seconds{19});
  // The frames alone take more than four seconds on the bus, most of them for objects that are not there.
  EXPECT_LT(report.time - time_of(report, "device."), seconds{15});
}

TEST(Times, OfASilentClientAndOfAHeartbeatPassAtOnce) {
  const RunReport report = run_checks({});
  EXPECT_LT(time_of(report, "error-control.heartbeat-period"), milliseconds{2200});
  EXPECT_LT(time_of(report, "sdo.silent-client"), milliseconds{100});
}

/// Falls silent until a reset once an upload of 1008h has waited for more than a second.
Defect that_never_recovers() {
  return {.incoming = [](Slave& slave, Frame& frame) {
    constexpr std::int64_t kSecond = 1'000'000'000;
    const std::int64_t now = slave.now().time_since_epoch().count();
    if (is_command(frame, canopen::NmtCommand::ResetNode)) slave.memory.clear();
    if (frame.id != kRequestOf5 || frame.remote) return true;
    const bool late = slave.memory["begun"] != 0 && now - slave.memory["begun"] > kSecond;
    if (late) slave.memory["gone"] = 1;
    const bool begins = frame.data[0] == 0x40 && frame.data[1] == 0x08 && frame.data[2] == 0x10;
    slave.memory["begun"] = begins ? now : 0;
    return slave.memory["gone"] == 0;
  }};
}

TEST(Times, OfASilentClientThatIsNotBorneAreNoMatterOfTheHeartbeat) {
  const RunReport report = run_checks(that_never_recovers());
  EXPECT_EQ(failed_checks(report), std::set<std::string>{"sdo.silent-client"}) << findings_of(report);
}

TEST(Times, OfOneCheckAreItsOwn) {
  const RunReport heartbeat = run_checks({}, "error-control.heartbeat-period");
  EXPECT_LT(heartbeat.time, milliseconds{1500});
  const RunReport silence = run_checks({}, "sdo.silent-client");
  EXPECT_GE(silence.time, seconds{2});
  EXPECT_EQ(findings_of(silence), "");
}

TEST(Times, OfEmergencyChecksAreThoseOfOneError) {
  std::size_t errors = 0;
  const RunReport report = run_checks({.outgoing =
                                           [&](Slave& slave, Frame& frame) {
                                             if (is_emergency(slave, frame, 0x8130)) ++errors;
                                             return true;
                                           }},
                                      "emcy.");
  EXPECT_EQ(findings_of(report), "");
  // Of all of them, of the other identifier, of the inhibit time, and before the history is deleted.
  EXPECT_LE(errors, 4U);
  EXPECT_LT(report.time, seconds{2});
}

/// Tells an error once until it is reset, and never its end.
Defect with_errors_that_last() {
  return {.incoming =
              [](Slave& slave, Frame& frame) {
                if (is_command(frame, canopen::NmtCommand::ResetNode)) slave.memory["told"] = 0;
                return true;
              },
          .outgoing =
              [](Slave& slave, Frame& frame) {
                if (frame.id != slave.cob_id(kEmcy)) return true;
                return !is_emergency(slave, frame, 0) && std::exchange(slave.memory["told"], 1) == 0;
              }};
}

TEST(Times, OfErrorsThatLastAreThoseOfAReset) {
  const RunReport report = run_checks(with_errors_that_last(), "emcy.");
  EXPECT_EQ(failed_checks(report), std::set<std::string>{"emcy.error-reset"}) << findings_of(report);
  EXPECT_LT(report.time, milliseconds{2500});
}

}  // namespace
}  // namespace conformance_test
