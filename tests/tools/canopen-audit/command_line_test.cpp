#include <sstream>

#include "tests/tools/canopen-audit/audit_run.hpp"

namespace audit_tool_test {
namespace {

using CanopenAudit = AuditRun;

TEST_F(CanopenAudit, ListsTheRulesThatTheDocumentationHas) {
  const fakes::Finished list = run({"--list=markdown"});
  EXPECT_EQ(list.status, 0);
  std::ostringstream page;
  page << std::ifstream{std::string{SOURCE_FOLDER} + "/docs/reference/audit-rules.md"}.rdbuf();
  EXPECT_EQ(list.output, page.str()) << "cmake --build build/release --target update_audit_page";
}

TEST_F(CanopenAudit, ListsTheRulesAsPlainText) {
  const fakes::Finished list = run({"--list"});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.output.find("\nsdo.toggle "), std::string::npos) << list.output;
  EXPECT_EQ(list.output.find('`'), std::string::npos);
}

struct Mistake {
  const char* name;
  std::vector<std::string> words;
  const char* message;
};

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest's name
void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class Mistakes : public AuditRun, public testing::WithParamInterface<Mistake> {};

TEST_P(Mistakes, AreSaidInOneLineWithStatus2) {
  const fakes::Finished finished = run(GetParam().words);
  EXPECT_EQ(finished.status, 2) << finished.output;
  EXPECT_EQ(finished.errors, std::string{"canopen-audit: "} + GetParam().message + "\n");
  EXPECT_EQ(finished.output, "");
}

INSTANTIATE_TEST_SUITE_P(
    CanopenAudit, Mistakes,
    testing::Values(
        Mistake{"Nothing", {}, "expected either LOG or --interface"},
        Mistake{"LogAndInterface", {"x.log", "--interface", "can0"}, "expected either LOG or --interface"},
        Mistake{"BadUrl",
                {"--interface", "udp-multicast://x"},
                "--interface: expected a port 1 to 65535 behind the group, got \"udp-multicast://x\""},
        Mistake{"EdsWithoutNode",
                {"x.log", "--eds", "drive.eds"},
                "--eds: expected NODE:FILE, the node-ID (1 to 127) and its EDS, got \"drive.eds\""},
        Mistake{"EdsOfNodeTooHigh",
                {"x.log", "--eds", "128:drive.eds"},
                "--eds: expected NODE:FILE, the node-ID (1 to 127) and its EDS, got \"128:drive.eds\""},
        Mistake{"EdsWithoutFile",
                {"x.log", "--eds", "5:"},
                "--eds: expected NODE:FILE, the node-ID (1 to 127) and its EDS, got \"5:\""},
        Mistake{"TwoEdsOfANode",
                {"x.log", "--eds", "5:a.eds", "--eds", "5:b.eds"},
                "--eds: expected one a node, got two of node 5"},
        Mistake{"NoSuchEds",
                {"x.log", "--eds", "5:/nowhere/a.eds"},
                "/nowhere/a.eds: cannot be read: No such file or directory"},
        Mistake{"NoSuchKnown",
                {"x.log", "--known", "/nowhere/known.json"},
                "/nowhere/known.json: cannot be read: No such file or directory"},
        Mistake{"NoSuchLog", {"/nowhere/x.log"}, "/nowhere/x.log: No such file or directory"},
        Mistake{"AFolder", {"/usr"}, "/usr: expected a log of candump, this is no regular file"},
        Mistake{"ADevice", {"/dev/null"}, "/dev/null: expected a log of candump, this is no regular file"},
        Mistake{"SecondsOfALog",
                {"x.log", "--seconds", "3"},
                "--seconds: is for --interface, a log is read to its end"},
        Mistake{"OneOfLive",
                {"--interface", "can0", "--of", "can0"},
                "--of: is for a log, --interface has one interface"},
        Mistake{"JunitThatCannotBeWritten",
                {"x.log", "--junit", "/nowhere/report.xml"},
                "/nowhere/report.xml: cannot be written"},
        Mistake{"JsonThatCannotBeWritten",
                {"x.log", "--json", "/nowhere/report.json"},
                "/nowhere/report.json: cannot be written"}),
    [](const testing::TestParamInfo<Mistake>& each) { return std::string{each.param.name}; });

TEST_F(CanopenAudit, EndsWith3IfThereIsNoBus) {
  const fakes::Finished finished = run({"--interface", "nosuch0", "--seconds", "1"});
  EXPECT_EQ(finished.status, 3) << finished.output;
  EXPECT_TRUE(finished.errors.starts_with("canopen-audit: ")) << finished.errors;
  EXPECT_EQ(finished.errors.find('\n'), finished.errors.size() - 1) << finished.errors;
}

TEST_F(CanopenAudit, RefusesAnEdsThatIsNone) {
  const std::string sheet = write("a.eds", "nothing");
  const fakes::Finished finished = audit(kRight, {"--eds", "5:" + sheet});
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.errors, "canopen-audit: a.eds: expected an EDS, found no object in it\n");
}

TEST_F(CanopenAudit, CountsAWarningAsAFailureIfItIsTold) {
  EXPECT_EQ(audit(kAbortAlone).status, 0);
  EXPECT_EQ(audit(kAbortAlone, {"--strict"}).status, 1);
  EXPECT_EQ(audit(kOverlap).status, 1);
  EXPECT_EQ(audit(kRight, {"--strict"}).status, 0);
}

TEST_F(CanopenAudit, ShowsWhatItHasFoundThoughAReportCannotBeWritten) {
  for (const char* const option : {"--junit", "--json"}) {
    const fakes::Finished finished = audit(kOverlap, {option, "/dev/full"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.errors, "canopen-audit: /dev/full: cannot be written\n");
    EXPECT_NE(finished.output.find("sdo.overlap"), std::string::npos) << finished.output;
  }
}

TEST_F(CanopenAudit, SaysThatStandardOutputCannotBeWritten) {
  const std::string log = write("x.log", kRight);
  const fakes::Finished finished =
      fakes::run_program({"/bin/sh", "-c", std::string{CANOPEN_AUDIT} + " '" + log + "' > /dev/full"});
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.errors, "canopen-audit: standard output cannot be written\n");
}

}  // namespace
}  // namespace audit_tool_test
