#include "tests/tools/canopen-audit/audit_run.hpp"

namespace audit_tool_test {
namespace {

using nlohmann::json;

using CanopenAuditReport = AuditRun;

TEST_F(CanopenAuditReport, ShowsFramesWithTheirPlacesAndWhatTheyMean) {
  const fakes::Finished finished = audit(std::string{kRight} + "(2.0) can0 705#00\n" +
                                         "(2.1) can0 605#4000100000000000\n(2.1002) can0 605#4001100000000000\n");
  EXPECT_NE(
      finished.output.find("error    sdo.overlap                      a request is sent before the answer to the "
                           "last one (CiA 301 7.2.4.2)\n    node 5: "),
      std::string::npos)
      << finished.output;
  EXPECT_NE(
      finished.output.find("      line 4: (1.100000) 605#4000100000000000  SDO request to node 5: read 1000h:00\n"
                           "      line 5: (1.100200) 605#4001100000000000  SDO request to node 5: read 1001h:00\n"
                           "    mend: "),
      std::string::npos)
      << finished.output;
  EXPECT_TRUE(finished.output.ends_with("\nx.log: 5 frames in 1.100 s: errors 1, warnings 0\n"))
      << finished.output;
}

TEST_F(CanopenAuditReport, IsOneLineIfThereIsNothingToSay) {
  EXPECT_EQ(audit(kRight).output, "x.log: 2 frames in 0.001 s: no rule is broken\n");
}

TEST_F(CanopenAuditReport, CountsFindingsBeyondTheFirstTen) {
  const std::string log = aborts(13);
  const fakes::Finished finished = audit(log);
  EXPECT_NE(finished.output.find("    and 3 times more\n"), std::string::npos) << finished.output;
  EXPECT_TRUE(finished.output.ends_with(": errors 0, warnings 13\n")) << finished.output;
  EXPECT_EQ(report(log)["rules"], (json{{"sdo.abort-alone", 13}}));
}

TEST_F(CanopenAuditReport, HasTheTimeLinesOfNodes) {
  const fakes::Finished finished = audit("(5.0) can0 705#00\n(5.5) can0 000#0105\n", {"--time-lines"});
  EXPECT_NE(finished.output.find("node 5\n      0.000000  boot-up\n      0.500000  NMT start\n"),
            std::string::npos)
      << finished.output;
  const json lines = report("(5.0) can0 705#00\n(5.5) can0 000#0105\n")["time_lines"]["5"];
  EXPECT_EQ(lines["milestones"][1], (json{{"s", 0.5}, {"place", 2}, {"text", "NMT start"}})) << lines;
  EXPECT_EQ(lines["left_out"], 0);
}

TEST_F(CanopenAuditReport, AsJsonSaysWhatWasFound) {
  const json found = report(kOverlap);
  EXPECT_EQ(found["tool"], "canopen-audit");
  EXPECT_EQ(found["frames"], 2);
  EXPECT_EQ(found["errors"], 1);
  EXPECT_EQ(found["warnings"], 0);
  EXPECT_EQ(found["known"], 0);
  ASSERT_EQ(found["findings"].size(), 1U) << found;
  const json& finding = found["findings"][0];
  EXPECT_EQ(finding["rule"], "sdo.overlap");
  EXPECT_EQ(finding["severity"], "error");
  EXPECT_EQ(finding["node"], 5);
  const json last{{"frame", "(0000.000200) can0 605#4001100000000000"},
                  {"place", 2},
                  {"words", "SDO request to node 5: read 1001h:00"},
                  {"s", finding["frames"][1]["s"]}};
  EXPECT_EQ(finding["frames"][1], last);
}

TEST_F(CanopenAuditReport, AsJsonHasNoTimesWithoutTimeStamps) {
  const json found =
      report("can0  605   [8]  40 00 10 00 00 00 00 00\ncan0  605   [8]  40 01 10 00 00 00 00 00\n");
  EXPECT_FALSE(found["findings"][0]["frames"][0].contains("s")) << found;
}

TEST_F(CanopenAuditReport, AsJunitIsAcceptedByItsSchema) {
  const std::string list =
      write("known.json", R"([{"rule": "sdo.abort-alone", "reason": "<it> & \"so\"", "source": "s"}])");
  for (const std::string& log :
       {std::string{kRight}, std::string{kOverlap}, std::string{kAbortAlone} + "(2.0) can0 705#00\n"}) {
    (void)audit(log, {"--junit", folder_.path("x.xml"), "--known", list});
    const fakes::Finished xmllint =
        fakes::run_program({XMLLINT, "--noout", "--schema", JUNIT_SCHEMA, folder_.path("x.xml")});
    EXPECT_EQ(xmllint.status, 0) << xmllint.errors;
  }
}

TEST_F(CanopenAuditReport, AsJunitHasAFailureForAnErrorAndNoneForAWarning) {
  const auto junit = [this](std::string_view log) {
    (void)audit(log, {"--junit", folder_.path("x.xml")});
    std::string text{std::istreambuf_iterator{std::ifstream{folder_.path("x.xml")}.rdbuf()}, {}};
    return text;
  };
  const std::string error = junit(kOverlap);
  EXPECT_NE(error.find("failures=\"1\""), std::string::npos) << error;
  EXPECT_NE(error.find("message=\"a request is sent before the answer to the last one (1 times)\""),
            std::string::npos)
      << error;
  const std::string warning = junit(kAbortAlone);
  EXPECT_EQ(warning.find("<failure"), std::string::npos) << warning;
  EXPECT_NE(warning.find("605#8017100000000405"), std::string::npos) << warning;
}

}  // namespace
}  // namespace audit_tool_test
