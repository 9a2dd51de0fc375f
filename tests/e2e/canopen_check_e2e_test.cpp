#include <csignal>
#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/conformance_run.hpp"
#include "tests/e2e/daemon_process.hpp"

/// canopen-check against axisd, and against what stands in its way.
namespace e2e {
namespace {

using nlohmann::json;

const std::string kEdsFolder = EDS_FOLDER;

std::string eds_of(int axes) {
  return kEdsFolder + (axes == 1 ? "/axisd.eds" : "/axisd-" + std::to_string(axes) + "-axes.eds");
}

/// canopen-check on node 5 with @p words.
std::vector<std::string> command(const std::vector<std::string>& words) {
  std::vector<std::string> command{CANOPEN_CHECK_PROGRAM, "--interface", served_interface(), "--node", "5"};
  command.insert(command.end(), words.begin(), words.end());
  return command;
}
fakes::Finished run_check(const std::vector<std::string>& words) {
  return fakes::run_program(command(words), bus_environment());
}

/// The checks that the list of deviations of the unit names.
std::set<std::string> listed() {
  std::set<std::string> ids;
  std::ifstream file{kEdsFolder + "/axisd-deviations.json"};
  for (const json& item : json::parse(file)) ids.insert(item.at("check"));
  return ids;
}

/// Listed checks that ran.
std::set<std::string> listed_and_run(const Outcomes& outcomes) {
  std::set<std::string> ids = listed();
  for (const std::string& id : checks_with(outcomes, "skipped")) ids.erase(id);
  return ids;
}

const std::set<std::string> kNone;

class Conformance : public testing::TestWithParam<int> {};

TEST_P(Conformance, HasTheListedDeviationsAndNoFinding) {
  DaemonProcess daemon{{.axes = GetParam()}};
  ASSERT_TRUE(daemon.is_ready());
  const Outcomes outcomes =
      conformance(command({"--eds", eds_of(GetParam()), "--deviations", kEdsFolder + "/axisd-deviations.json"}));
  EXPECT_EQ(checks_with(outcomes, "failed"), kNone);
  EXPECT_EQ(checks_with(outcomes, "deviation"), listed_and_run(outcomes));
}

INSTANTIATE_TEST_SUITE_P(Axes, Conformance, testing::Values(1, 8));

TEST(ConformanceWithoutAList, FindsEveryListedDeviation) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  const Outcomes outcomes = conformance(command({"--eds", eds_of(1)}), listed());
  EXPECT_EQ(checks_with(outcomes, "failed"), listed_and_run(outcomes));
}

TEST(ConformanceWithEverythingAllowed, HasTheListedDeviationsAndNoFinding) {
  DaemonProcess daemon{{.axes = 2}};
  ASSERT_TRUE(daemon.is_ready());
  const Outcomes outcomes =
      conformance(command({"--eds", eds_of(2), "--deviations", kEdsFolder + "/axisd-deviations.json",
                           "--allow-store", "--allow-motion"}));
  EXPECT_EQ(checks_with(outcomes, "failed"), kNone);
  EXPECT_EQ(checks_with(outcomes, "deviation"), listed_and_run(outcomes));
}

TEST(ConformanceReadOnly, LeavesTheUnitAlone) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  const Outcomes outcomes = conformance(
      command({"--eds", eds_of(1), "--read-only", "--deviations", kEdsFolder + "/axisd-deviations.json"}));
  EXPECT_EQ(checks_with(outcomes, "failed"), kNone);
  EXPECT_EQ(daemon.status().at("nmt_state"), "Pre-operational");
}

TEST(ConformanceTrouble, WithoutANodeEndsWithStatus3) {
  const CanClient somebody_on_the_bus{kTestInterface};
  const fakes::Finished run = run_check({"--timeout", "100"});
  EXPECT_EQ(run.status, 3) << run.output;
  EXPECT_NE(run.errors.find("node 5 does not answer an upload of 1000h:00 (request 605h, 100.0 ms)"),
            std::string::npos)
      << run.errors;
}

TEST(ConformanceTrouble, WithAnotherDevicesEdsWritesNothingAndSaysSo) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  const fakes::TemporaryDirectory folder;
  std::ifstream file{eds_of(1)};
  std::string eds{std::istreambuf_iterator<char>{file}, {}};
  constexpr std::string_view kProduct = "ProductNumber=0x00005000";
  eds.replace(eds.find(kProduct), kProduct.size(), "ProductNumber=0x00005001");
  std::ofstream{folder.path("other.eds")} << eds;
  const fakes::Finished run = run_check({"--eds", folder.path("other.eds"), "--only", "nmt,device.identity"});
  EXPECT_EQ(run.status, 1) << run.output;
  EXPECT_NE(run.errors.find("the EDS is of another device: 1018h:02 is 00005000h, the EDS says 00005001h"),
            std::string::npos)
      << run.errors;
  EXPECT_EQ(daemon.status().at("nmt_state"), "Pre-operational");
}

TEST(ConformanceTrouble, WithANodeThatDisappearsEndsWithAReport) {
  CanClient can{kTestInterface};
  DaemonProcess daemon;
  ASSERT_TRUE(can.wait_for("705#00")) << "of its start";
  Program check{{CANOPEN_CHECK_PROGRAM, "--interface", served_interface(), "--node", "5", "--eds", eds_of(1),
                 "--only", "nmt,sdo", "--boot-limit", "2000"},
                bus_environment()};
  ASSERT_TRUE(can.wait_for("705#00"));  // it has begun to reset the node
  EXPECT_EQ(daemon.end(SIGKILL), -SIGKILL);
  EXPECT_EQ(check.wait(), 1);
}

TEST(ConformanceTrouble, WhenItIsInterruptedRestoresWhatItChanged) {
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());
  CanClient can{kTestInterface};
  Program check{{CANOPEN_CHECK_PROGRAM, "--interface", served_interface(), "--node", "5", "--eds", eds_of(1),
                 "--only", "error-control"},
                bus_environment()};
  // The heartbeat time is written, and nothing of it is left afterwards.
  ASSERT_TRUE(can.wait_until("a write of 1017h", [](const canopen::Frame& frame) {
    return frame.id == 0x605 && frame.data[0] == 0x2B && frame.data[1] == 0x17 && frame.data[4] != 0;
  }));
  check.signal(SIGINT);
  EXPECT_EQ(check.wait(), 1);
  // Everything up to the answer to a request of which no check makes one is the run's.
  can.send("605#4008100000000000");
  ASSERT_TRUE(can.wait_until("the answer of 1008h", [](const canopen::Frame& frame) {
    return frame.id == 0x585 && frame.data[1] == 0x08 && frame.data[2] == 0x10;
  }));
  EXPECT_TRUE(can.ask("605#4017100000000000", "585#4B17100000000000"));
}

}  // namespace
}  // namespace e2e
