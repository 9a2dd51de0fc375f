#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

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
  EXPECT_EQ(words.size(), 21U);
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

/// A file with @p count objects of the manufacturer, each of which has a key that CiA 306 does not know.
std::string many_warnings(unsigned count) {
  std::string text = eds::content_of(kCorpus + "good/minimal.eds"), list;
  text.erase(text.find("[ManufacturerObjects]"));
  for (unsigned n = 1; n <= count; ++n) {
    char index[5] = {};
    std::snprintf(index, sizeof index, "%04X", 0x2000 + n);
    list += std::to_string(n) + "=0x" + index + "\n";
    text += std::string{"["} + index +
            "]\nParameterName=Value\nDataType=0x0005\nAccessType=rw\nPDOMapping=0\nUnit=" + std::to_string(n) +
            "\n";
  }
  return text + "[ManufacturerObjects]\nSupportedObjects=" + std::to_string(count) + "\n" + list;
}

struct EdstoolLintChoice : testing::Test {
  fakes::TemporaryDirectory folder;

  std::string file(const std::string& name, const std::string& text) const {
    std::string path = folder.path(name);
    std::ofstream{path, std::ios::binary} << text;
    return path;
  }
};

TEST_F(EdstoolLintChoice, TellsOnceOfWarningsThatAreAlikeAndEndsWithZero) {
  const std::string path = file("minimal.eds", many_warnings(649));
  const auto done = run({"lint", path});

  EXPECT_EQ(done.status, 0);
  EXPECT_EQ(done.output,
            path +
                ":88: warning: [2001] Unit: expected a key of CiA 306, got Unit=1 (key-unknown), and 648 "
                "like it to line 3976\n");
  EXPECT_EQ(json::parse(run({"--json", "lint", path}).output).size(), 649U);
  const std::string all = run({"lint", "--all", path}).output;
  EXPECT_EQ(std::ranges::count(all, '\n'), 649);
}

TEST_F(EdstoolLintChoice, LeavesOutWhatIsIgnoredAndWhatIsLessSevere) {
  const std::string path = kCorpus + "wrong/standard-access.eds";
  const std::string list =
      file("ignored", "# known\r\nstandard-access:1000 # the type\n\nstandard-access:1003SUB0\n");

  EXPECT_EQ(run({"lint", path, "--ignore", "standard-access"}).output, "");
  EXPECT_EQ(run({"lint", path, "--ignore", "standard-access"}).status, 0);
  const std::string errors = run({"lint", "--severity", "error", path}).output;
  EXPECT_EQ(std::ranges::count(errors, '\n'), 5);
  EXPECT_EQ(errors.find("warning"), std::string::npos);
  const auto rest = run(
      {"lint", "--ignore-list", list, "--ignore", "bit-rate,standard-access:1010sub1", "--severity=error", path});
  EXPECT_EQ(rest.status, 1);
  EXPECT_EQ(std::ranges::count(rest.output, '\n'), 2);
  EXPECT_EQ(run({"lint", "--ignore-list", file("wrong", "bit-rate\nnothing\n"), path}).errors,
            "edstool: " + folder.path("wrong") + ":2: there is no check \"nothing\"\n");
}

TEST_F(EdstoolLintChoice, ReadsRegularFilesOfABoundedSizeOnly) {
  const std::string pipe = folder.path("pipe.eds"), large = file("large.eds", "");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::resize_file(large, (std::uintmax_t{32} << 20U) + 1);

  EXPECT_EQ(run({"lint", pipe}).errors, "edstool: " + pipe + ": cannot be read: expected a regular file\n");
  EXPECT_EQ(run({"lint", large}).errors, "edstool: " + large + ": cannot be read: expected at most 32 MiB\n");
}

TEST(EdstoolShow, EndsWithZeroWhateverTheReaderFound) {
  for (const char* const name : {"wrong/value-form.eds", "wrong/number-range.eds", "wrong/encoding.eds"}) {
    const auto done = run({"show", kCorpus + name});
    EXPECT_EQ(done.status, 0) << name;
    EXPECT_NE(done.output, "") << name;
    EXPECT_NE(done.errors, "") << name;
  }
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

TEST(EdstoolDiff, FindsNoDifferenceOfAnyFileToItself) {
  unsigned files = 0;
  for (const char* const part : {"good", "wild", "wrong"})
    for (const auto& file : std::filesystem::directory_iterator{kCorpus + part}) {
      const std::string path = file.path().string();
      const bool sheet = path.ends_with(".eds") || path.ends_with(".dcf");
      if (!sheet) continue;
      ++files;
      const auto done = run({"diff", path, path});
      EXPECT_EQ(done.status, 0) << path;
      EXPECT_EQ(done.output, "") << path;
    }
  EXPECT_GT(files, 90U);
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

TEST(EdstoolFlatten, SaysThatAPlainFileHasNoModules) {
  const std::string file = kCorpus + "good/plain.eds";
  EXPECT_EQ(
      run({"flatten", "--modules=1", file}).errors,
      file + ": error: [SupportedModules]: expected the modules of a modular file, got none (module-number)\n");
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
      {{"lint", "/no/such/file"}, "edstool: /no/such/file: cannot be read: No such file or directory\n"},
      {{"lint", "/"}, "edstool: /: cannot be read: expected a regular file\n"},
      {{"lint", "/dev/zero"}, "edstool: /dev/zero: cannot be read: expected a regular file\n"},
      {{"lint", "--severity", "note", plain}, "edstool: --severity: note not in {error,warning}\n"},
      {{"lint", "--ignore", "no-such", plain}, "edstool: --ignore: there is no check \"no-such\"\n"},
      {{"lint", "--ignore", "bit-rate:", plain},
       "edstool: --ignore: expected CHECK or CHECK:SECTION, got \"bit-rate:\"\n"},
      {{"show", "/dev/null"}, "edstool: /dev/null: cannot be read: expected a regular file\n"},
      {{"show", "/bin/true"}, "edstool: /bin/true: expected an EDS or DCF, found no section in it\n"},
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
  EXPECT_NE(run({"--help"}).output.find("Exit status:\n   0  clean"), std::string::npos);
}

}  // namespace
