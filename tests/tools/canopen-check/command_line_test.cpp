#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/tools/canopen-check/slave/conformance_run.hpp"

/// canopen-check as a user meets it, without a bus.
namespace conformance_test {
namespace {

fakes::Finished run(std::vector<std::string> words) {
  words.insert(words.begin(), CANOPEN_CHECK);
  return fakes::run_program(words);
}

/// The rows of a table: lines that begin with "| `".
std::string rows_of(std::istream&& lines) {
  std::string rows;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("| `")) rows += line + "\n";
  return rows;
}

TEST(CanopenCheck, ListsTheChecksThatTheDocumentationLists) {
  const fakes::Finished list = run({"--list=markdown"});
  EXPECT_EQ(list.status, 0);
  EXPECT_EQ(rows_of(std::istringstream{list.output}),
            rows_of(std::ifstream{std::string{SOURCE_FOLDER} + "/docs/reference/conformance-checks.md"}));
}

TEST(CanopenCheck, ListsTheChecksAsPlainText) {
  const fakes::Finished list = run({"--list"});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.output.find("\nnmt.operational "), std::string::npos) << list.output;
  EXPECT_EQ(list.output.find_first_of("|`"), std::string::npos);
}

struct Mistake {
  const char* name;
  std::vector<std::string> words;
  const char* message;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreSaidInOneLineWithStatus2) {
  const fakes::Finished finished = run(GetParam().words);
  EXPECT_EQ(finished.status, 2) << finished.output;
  EXPECT_EQ(finished.errors, std::string{"canopen-check: "} + GetParam().message + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, Mistakes,
    testing::Values(
        Mistake{"NoInterface", {"--node", "5"}, "--interface: needed, unless --static asks for the EDS alone"},
        Mistake{"NoNode", {"--interface", "vcan0"}, "--node: needed, a node-ID 1 to 127"},
        Mistake{
            "NodeTooHigh", {"--interface", "vcan0", "--node", "128"}, "--node: Value 128 not in range 1 to 127"},
        Mistake{"UnknownCheckToSkip",
                {"--interface", "vcan0", "--node", "5", "--skip", "nmt.no-such"},
                "--skip: expected a group (static, device, nmt, error-control, sdo, pdo, sync, emcy, storage, "
                "lss, drive, "
                "robustness) or the beginning of an id (see --list), got \"nmt.no-such\""},
        Mistake{"ReportThatCannotBeWritten",
                {"--interface", "unix:/nowhere/bus", "--node", "5", "--junit", "/nowhere/report.xml"},
                "/nowhere/report.xml: cannot be written"},
        Mistake{"StaticWithoutEds", {"--static"}, "--static: needs --eds FILE"},
        Mistake{"NoSuchFile",
                {"--static", "--eds", "/nowhere/a.eds"},
                "/nowhere/a.eds: cannot be read: No such file or directory"},
        Mistake{"BadUrl",
                {"--interface", "udp-multicast://x", "--node", "5"},
                "--interface: expected a port 1 to 65535 behind the group, got \"udp-multicast://x\""},
        Mistake{"TwoModes",
                {"--static", "--full", "--eds", "x.eds"},
                "Requires at most 1 options be given from [--static,--read-only,--full]"}),
    [](const testing::TestParamInfo<Mistake>& each) { return std::string{each.param.name}; });

TEST(CanopenCheck, JudgesAnEdsAlone) {
  const fakes::TemporaryDirectory folder;
  std::string eds = eds_of(right_objects());
  std::ofstream{folder.path("right.eds")} << eds;
  EXPECT_EQ(run({"--static", "--eds", folder.path("right.eds")}).status, 0);

  eds.insert(eds.find("[1001]"), "[1000]\nParameterName=Again\n\n");
  std::ofstream{folder.path("right.eds")} << eds;
  const fakes::Finished wrong = run({"--static", "--eds", folder.path("right.eds")});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.output.find("failed    static.duplicate-section"), std::string::npos) << wrong.output;
}

TEST(CanopenCheck, RefusesAListOfDeviationsThatIsNone) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("list.json")} << "{";
  std::ofstream{folder.path("right.eds")} << eds_of(right_objects());
  const fakes::Finished refused =
      run({"--static", "--eds", folder.path("right.eds"), "--deviations", folder.path("list.json")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.errors,
            "canopen-check: " + folder.path("list.json") + ": expected a JSON list of {check, reason, source}\n");
}

TEST(CanopenCheck, SaysThatAReportCannotBeWritten) {
  const fakes::TemporaryDirectory folder;
  std::ofstream{folder.path("right.eds")} << eds_of(right_objects());
  const fakes::Finished finished = run({"--static", "--eds", folder.path("right.eds"), "--junit", "/dev/full"});
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.errors, "canopen-check: /dev/full: cannot be written\n");
}

}  // namespace
}  // namespace conformance_test
