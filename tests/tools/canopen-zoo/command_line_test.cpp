#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "eds/lint/lint.hpp"
#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

/// canopen-zoo as a user meets it, without a bus.
namespace {

fakes::Finished run(std::vector<std::string> words) {
  words.insert(words.begin(), CANOPEN_ZOO);
  return fakes::run_program(words);
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream{path}.rdbuf();
  return text.str();
}

TEST(CanopenZoo, ListsTheSlavesThatTheDocumentationLists) {
  EXPECT_EQ(run({"--list=markdown"}).output, text_of(std::string{SOURCE_FOLDER} + "/docs/reference/zoo-slaves.md"))
      << "ninja update_zoo_page";
}

TEST(CanopenZoo, ListsEverySlaveOnceWithASentenceAsJson) {
  const nlohmann::json list = nlohmann::json::parse(run({"--list", "--json"}).output);
  std::set<std::string> names, sentences;
  for (const nlohmann::json& slave : list) {
    const std::string what = slave.at("what");
    EXPECT_TRUE(names.insert(slave.at("name")).second) << slave;
    EXPECT_TRUE(sentences.insert(what).second) << slave;
    EXPECT_TRUE(what.ends_with('.')) << what;
    EXPECT_EQ(slave.at("found_by").empty(), what.starts_with("Nothing is wrong")) << slave;
  }
  EXPECT_GT(names.size(), 150U);
}

TEST(CanopenZoo, ListsALineEachAsText) {
  const std::string list = run({"--list"}).output;
  EXPECT_NE(
      list.find("\nNeverToggles                                 The toggle bit stays 0 in its upload of 1008h. "
                "(sdo.toggle-bit)\n"),
      std::string::npos)
      << list;
}

TEST(CanopenZoo, WritesAnEdsWithoutAFinding) {
  const fakes::Finished written = run({"--right", "--eds", "-"});
  EXPECT_EQ(written.status, 0);
  const eds::Findings findings = eds::lint(written.output, "right.eds");
  for (const eds::Finding& finding : findings.all()) ADD_FAILURE() << eds::to_text(finding);
}

TEST(CanopenZoo, WritesTheEdsThatIsWrongToAFile) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("wrong.eds");
  EXPECT_EQ(run({"--run", "has-dummies-that-its-eds-forbids", "--eds", path}).status, 0);
  EXPECT_NE(text_of(path).find("Dummy0006=0"), std::string::npos);
}

struct Mistake {
  const char* name;
  std::vector<std::string> words;
  const char* message;
  int status = 2;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreToldInOneLine) {
  const fakes::Finished finished = run(GetParam().words);
  EXPECT_EQ(finished.status, GetParam().status);
  EXPECT_EQ(finished.errors, std::string{"canopen-zoo: "} + GetParam().message + "\n");
  EXPECT_EQ(finished.output, "");
}

INSTANTIATE_TEST_SUITE_P(
    CanopenZoo, Mistakes,
    testing::Values(
        Mistake{"Nothing", {}, "expected --list, --run NAME or --right"},
        Mistake{"NearlyAName",
                {"--run", "NeverTogles", "--interface", "unix:/x", "--node", "5"},
                "--run: no slave is called \"NeverTogles\", did you mean NeverToggles?"},
        Mistake{"NoName", {"--run", "Teapot", "--eds", "-"}, "--run: expected a name of --list, got \"Teapot\""},
        Mistake{"NoInterface", {"--right"}, "--interface: needed, unless --eds asks for the EDS alone"},
        Mistake{"NoNode", {"--right", "--interface", "unix:/x"}, "--node: needed, a node-ID 1 to 127"},
        Mistake{"NodeTooHigh",
                {"--right", "--interface", "unix:/x", "--node", "128"},
                "--node: Value 128 not in range 1 to 127"},
        Mistake{"Both", {"--right", "--run", "NeverToggles"}, "--run excludes --right"},
        Mistake{"JsonOfNothing", {"--json"}, "--json: needs --list"},
        Mistake{"NoBusOfThatName",
                {"--right", "--interface", "udp-multicast://x", "--node", "5"},
                "--interface: expected a port 1 to 65535 behind the group, got \"udp-multicast://x\""},
        Mistake{"NoBus",
                {"--right", "--interface", "unix:/nowhere/bus", "--node", "5"},
                "unix:/nowhere/bus: cannot be served by canhub (run canhub --path to see why)",
                1},
        Mistake{"EdsNowhere", {"--right", "--eds", "/nowhere/x.eds"}, "/nowhere/x.eds: cannot be written"}),
    [](const testing::TestParamInfo<Mistake>& each) { return std::string{each.param.name}; });

}  // namespace
