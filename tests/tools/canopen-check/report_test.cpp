#include "tools/canopen-check/report/report.hpp"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace conformance_test {
namespace {

using namespace conformance;
using nlohmann::json;

constexpr Check kToggle{.id = "sdo.toggle-bit",
                        .name = "A wrong toggle bit is <refused>",
                        .clause = "CiA 301 7.2.4",
                        .group = Group::Sdo};
constexpr Check kHeartbeat{
    .id = "error-control.heartbeat", .name = "It beats", .clause = "CiA 301 7.2.8", .group = Group::ErrorControl};

canopen::TimePoint at(int milliseconds) {
  return canopen::TimePoint{std::chrono::milliseconds{milliseconds}};
}

/// A result of every outcome, with texts that a report must not take as they are.
RunReport every_outcome() {
  const TimedFrame request{
      .time = at(1000), .frame = {.id = 0x605, .length = 8, .data = {0x40, 0x00, 0x10}}, .sent = true};
  const TimedFrame guard{.time = at(1500), .frame = {.id = 0x705, .length = 1, .remote = true}};
  RunReport report{.reached = true, .time = std::chrono::milliseconds{1500}};
  report.results = {
      {.check = &kToggle, .outcome = Outcome::Passed, .notes = {"100 ms & \"more\""}},
      {.check = &kToggle,
       .outcome = Outcome::Failed,
       .findings =
           {{.subject = {0x1000, 0}, .expected = "a < b", .found = "\x01\xFF & c", .frames = {request, guard}}}},
      {.check = &kToggle,
       .outcome = Outcome::Deviates,
       .findings = {{.subject = {0x1003, {}}, .expected = "x", .found = "y", .deviation = "it is so"}}},
      {.check = &kHeartbeat, .outcome = Outcome::Skipped, .reason = "object 1017h is not in the EDS"},
      {.check = &kHeartbeat, .outcome = Outcome::Broken, .reason = "interrupted"}};
  return report;
}

const RunInfo kInfo{
    .version = "0.1.0", .interface = "vcan0", .node_id = 5, .mode = "full", .eds = "a&b.eds", .device = "x"};

TEST(JunitReport, IsAcceptedByItsSchema) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("report.xml")} << junit_of(every_outcome(), kInfo);
  const fakes::Finished xmllint =
      fakes::run_program({XMLLINT, "--noout", "--schema", JUNIT_SCHEMA, folder.path("report.xml")});
  EXPECT_EQ(xmllint.status, 0) << xmllint.errors << junit_of(every_outcome(), kInfo);
}

TEST(JunitReport, CountsBySuiteAndInAll) {
  const std::string text = junit_of(every_outcome(), kInfo);
  EXPECT_NE(text.find(R"(<testsuites name="canopen-check" tests="5" failures="1" errors="1" skipped="1")"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(<testsuite name="SDO" tests="3" failures="1" errors="0" skipped="0")"), std::string::npos)
      << text;
  EXPECT_NE(text.find(R"(<testsuite name="Error control" tests="2" failures="0" errors="1" skipped="1")"),
            std::string::npos)
      << text;
}

TEST(JunitReport, ShowsTheFramesOfAFailedCheckAsCandumpLogsThem) {
  EXPECT_NE(junit_of(every_outcome(), kInfo).find("(000000.000000) vcan0 605#4000100000000000"),
            std::string::npos);
  EXPECT_NE(junit_of(every_outcome(), kInfo).find("(000000.500000) vcan0 705#R1"), std::string::npos);
}

TEST(JsonReport, SaysWhatBecameOfEveryCheck) {
  const json report = json_of(every_outcome(), kInfo);
  EXPECT_EQ(report["counts"],
            (json{{"passed", 1}, {"deviation", 1}, {"failed", 1}, {"skipped", 1}, {"broken", 1}}));
  ASSERT_EQ(report["results"].size(), 5U);
  EXPECT_EQ(report["results"][1]["findings"][0]["object"], "1000h:00");
  EXPECT_EQ(report["results"][1]["findings"][0]["frames"][0]["frame"],
            "(000000.000000) vcan0 605#4000100000000000");
  EXPECT_EQ(report["results"][2]["findings"][0]["deviation"], "it is so");
  EXPECT_EQ(report["results"][3]["reason"], "object 1017h is not in the EDS");
}

TEST(TextReport, HasALineForAGroupAndOneForAll) {
  const std::string text = summary_of(every_outcome());
  EXPECT_NE(text.find("SDO                            1          1       1        0       0\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("in all                         1          1       1        1       1\n"), std::string::npos)
      << text;
}

TEST(TextReport, EndsWithTheFailures) {
  const std::string text = summary_of(every_outcome());
  EXPECT_NE(text.find("\nfailed    sdo.toggle-bit "), std::string::npos) << text;
  EXPECT_NE(text.find("\nbroken    error-control.heartbeat                  interrupted\n"), std::string::npos)
      << text;
}

TEST(JunitReport, TellsTheFirstFindingsInItsMessage) {
  RunReport report;
  report.results = {{.check = &kToggle,
                     .outcome = Outcome::Failed,
                     .findings = std::vector<Finding>(2000, Finding{.expected = "this", .found = "that"})}};
  const std::string text = junit_of(report, kInfo);
  EXPECT_NE(
      text.find(
          "message=\"expected this, found that; expected this, found that; expected this, found that; and 1997 "
          "more\""),
      std::string::npos);
}

}  // namespace
}  // namespace conformance_test
