#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/eds/corpus.hpp"
#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace {

using nlohmann::json;

const std::string kCorpus = std::string{SOURCE_FOLDER} + "/tests/data/eds/";
const std::string kGenerated = std::string{GENERATED_EDS_FOLDER} + "/";

fakes::Finished run(std::vector<std::string> words) {
  words.insert(words.begin(), EDSTOOL);
  return fakes::run_program(words);
}

TEST(EdstoolLint, IsSilentAboutEveryFileOfTheUnit) {
  std::vector<std::string> words{"lint"};
  for (const auto& file : std::filesystem::directory_iterator{GENERATED_EDS_FOLDER})
    if (file.path().extension() == ".eds") words.push_back(file.path().string());
  const auto done = run(words);

  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.output, "");
  EXPECT_EQ(done.errors, "");
  EXPECT_EQ(words.size(), 13U);
}

TEST(EdstoolLint, PrintsALineForEachFindingOfEachFile) {
  const std::string first = kCorpus + "wrong/line-form.eds", second = kCorpus + "wrong/node-id.dcf";
  const auto done = run({"lint", first, second});

  EXPECT_EQ(done.status, 1);
  EXPECT_EQ(done.output,
            first +
                ":4: error: [FileInfo]: expected [SECTION], KEY=VALUE or ;COMMENT, got no entry (line-form)\n" +
                first + ":5: error: [FileInfo]: expected [SECTION], KEY=VALUE or ;COMMENT, got =1 (line-form)\n" +
                second + ":87: error: [DeviceComissioning] NodeID: expected 1 to 127, got 128 (node-id)\n");
}

TEST(EdstoolLint, PrintsJson) {
  const std::string file = kCorpus + "wrong/node-id.dcf";
  const auto done = run({"--json", "lint", file});

  EXPECT_EQ(done.status, 1);
  EXPECT_EQ(json::parse(done.output), json::array({{{"file", file},
                                                    {"line", 87},
                                                    {"severity", "error"},
                                                    {"check", "node-id"},
                                                    {"section", "DeviceComissioning"},
                                                    {"key", "NodeID"},
                                                    {"expected", "1 to 127"},
                                                    {"found", "128"}}}));
  EXPECT_EQ(run({"lint", kCorpus + "good/plain.eds", "--json"}).output, "[]\n");
}

TEST(EdstoolShow, PrintsTheDeviceAndItsObjects) {
  const auto done = run({"show", kCorpus + "good/plain.eds"});

  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.output.substr(0, done.output.find('\n')),
            "Counter of Somebody, vendor 000001F0h, product 00000010h, revision 00010002h");
  EXPECT_NE(done.output.find("\n2000h  UNSIGNED16      rww   PDO Step = 1 (0..1000)\n"), std::string::npos);
  EXPECT_NE(done.output.find("\n  :02  INTEGER16       rw        Threshold of the middle = -1 (-100..0x64)\n"),
            std::string::npos);
}

TEST(EdstoolShow, PrintsJson) {
  const json shown = json::parse(run({"show", kCorpus + "good/plain.eds", "--json"}).output);

  EXPECT_EQ(shown.at("device").at("vendor_number"), 0x1F0);
  EXPECT_EQ(shown.at("objects").at(0).at("index"), 0x1000);
  EXPECT_EQ(shown.at("objects").at(0).at("entries").at(0).at("type"), "UNSIGNED32");
}

TEST(EdstoolDiff, TellsFilesApart) {
  const std::string one = kGenerated + "axisd.eds", two = kGenerated + "axisd-2-axes.eds";

  EXPECT_EQ(run({"diff", one, one}).status, 0);
  const auto done = run({"diff", one, two});
  EXPECT_EQ(done.status, 1);
  EXPECT_EQ(done.output.substr(0, done.output.find('\n')), "1027h:02: only in the second file");
  EXPECT_EQ(json::parse(run({"diff", one, two, "--json"}).output).at(0),
            json({{"where", "1027h:02"}, {"what", ""}, {"first", nullptr}, {"second", "Module 2"}}));
}

TEST(EdstoolFlatten, MakesTheUnitOfTwoAxes) {
  const fakes::TemporaryDirectory folder;
  const std::string flat = folder.path("flat.eds");

  const auto done = run({"flatten", "--modules", "1,2", kGenerated + "axisd-unit.eds", "--output", flat});

  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.output + done.errors, "");
  EXPECT_EQ(run({"lint", flat}).status, 0) << "it bears its own name";
  EXPECT_EQ(run({"diff", flat, kGenerated + "axisd-2-axes.eds"}).output, "");
}

TEST(EdstoolFlatten, RefusesAModuleThatIsNotThere) {
  const std::string file = kGenerated + "axisd-unit.eds";
  const auto done = run({"flatten", "--modules=1,17", file});

  EXPECT_EQ(done.status, 1);
  EXPECT_EQ(done.output, "");
  EXPECT_EQ(done.errors,
            file + ": error: [SupportedModules]: expected a module 1 to 16, got 17 (module-number)\n");
}

TEST(EdstoolDcf, ConfiguresANode) {
  const fakes::TemporaryDirectory folder;
  const std::string dcf = folder.path("five.dcf"), eds = kGenerated + "axisd.eds";

  const auto done = run({"dcf", "--node-id", "5", "--bit-rate", "500", "--set", "6083=1000", "--set",
                         "1400:1=0x80000000", eds, "--output", dcf});

  EXPECT_EQ(done.status, 0) << done.errors;
  EXPECT_EQ(run({"lint", dcf}).output, "");
  EXPECT_EQ(run({"diff", eds, dcf}).output,
            "1400h:01 ParameterValue: nothing -> 0x80000000\n6083h:00 ParameterValue: nothing -> 1000\n");
  EXPECT_NE(eds::content_of(dcf).find("[DeviceComissioning]\nNodeID=5\n"), std::string::npos);
}

TEST(EdstoolDcf, RefusesAValueThatIsNone) {
  const std::string file = kCorpus + "good/plain.eds";
  const auto done = run({"dcf", "--node-id=5", "--set", "2000=1001", file, "--json"});

  EXPECT_EQ(done.status, 1);
  const json result = json::parse(done.output);
  EXPECT_FALSE(result.contains("text"));
  EXPECT_EQ(result.at("findings").at(0).at("check"), "parameter-limits");
}

TEST(EdstoolSource, WritesADictionary) {
  const auto done = run({"c++", "--table", "kPlainObjects", kCorpus + "good/plain.eds"});

  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.output, eds::content_of(std::string{SOURCE_FOLDER} + "/tests/eds/transform/plain_objects.hpp"));
}

/// A wrong command line, and the line on standard error.
struct Misuse {
  std::vector<std::string> words;
  std::string message;
};

TEST(Edstool, SaysInOneLineWhatIsWrongWithTheCommandLine) {
  const std::string plain = kCorpus + "good/plain.eds";
  const std::vector<Misuse> cases{
      {{}, "edstool: A subcommand is required\n"},
      {{"lint"}, "edstool: files is required\n"},
      {{"lint", "/no/such/file"}, "edstool: /no/such/file: cannot be read\n"},
      {{"lint", "/"}, "edstool: /: cannot be read\n"},
      {{"flatten", plain}, "edstool: --modules is required\n"},
      {{"flatten", "--modules", "1,x", plain},
       "edstool: --modules: expected numbers separated by commas, as 1,1,2, got \"1,x\"\n"},
      {{"flatten", "--modules", "1,", plain},
       "edstool: --modules: expected numbers separated by commas, as 1,1,2, got \"1,\"\n"},
      {{"dcf", plain}, "edstool: --node-id is required\n"},
      {{"dcf", "--node-id", "5", "--set", "608=1", plain},
       "edstool: --set: expected INDEX=VALUE or INDEX:SUB=VALUE, as 6083=1000, got \"608=1\"\n"},
      {{"dcf", "--node-id", "5", plain, "--output", "/no/such/file"},
       "edstool: /no/such/file: cannot be written\n"},
      {{"c++", "--table", "1x", plain}, "edstool: --table: expected a name of C++, got \"1x\"\n"},
  };
  for (const Misuse& row : cases) {
    const auto done = run(row.words);
    EXPECT_EQ(done.status, 2) << row.message;
    EXPECT_EQ(done.errors, row.message);
    EXPECT_EQ(done.output, "");
  }
}

TEST(Edstool, ShowsHelpAndVersion) {
  EXPECT_EQ(run({"--version"}).status, 0);
  EXPECT_NE(run({"--help"}).output.find("Exit status: 0 clean"), std::string::npos);
}

}  // namespace
