#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "version/version.hpp"

namespace axisd {
namespace {

/// Runs the built axisd with a state directory of its own.
struct Program : testing::Test {
  fakes::TemporaryDirectory folder;

  fakes::Finished run(std::vector<std::string> words) const {
    words.insert(words.begin(), AXISD);
    return fakes::run_program(words, {"HOME=" + folder.path(), "RUNTIME_DIRECTORY=" + folder.path()});
  }
  /// Expects a refusal: @p status, nothing on standard output, one line on standard error.
  void expect_refusal(const std::vector<std::string>& words, int status, const std::string& line) const {
    const fakes::Finished finished = run(words);
    EXPECT_EQ(finished.status, status);
    EXPECT_EQ(finished.output, "");
    EXPECT_EQ(finished.errors, "axisd: " + line + "\n");
  }
};

TEST_F(Program, PrintsItsVersion) {
  const fakes::Finished finished = run({"--version"});

  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.output, version::line("axisd") + "\n");
  EXPECT_EQ(finished.errors, "");
}

TEST_F(Program, ListsEveryOptionInItsHelp) {
  const fakes::Finished finished = run({"--help"});

  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.errors, "");
  for (const char* const option :
       {"--config", "--interface", "--bus", "--profile", "--node-id", "--axes", "--state-directory", "--control",
        "--check-config", "--log-level", "--version", "--help"})
    EXPECT_NE(finished.output.find(option), std::string::npos) << option;
}

TEST_F(Program, RefusesACommandLineItDoesNotUnderstand) {
  expect_refusal({"--bogus"}, 2, "The following argument was not expected: --bogus (see axisd --help)");
  expect_refusal({"vcan0"}, 2, "The following argument was not expected: vcan0 (see axisd --help)");
  expect_refusal({"--profile", "402"}, 2, "--profile: expected s120 or cia402, got \"402\"");
  expect_refusal({"--node-id", "five"}, 2, "--node-id: expected an integer 0 to 127, got \"five\"");
}

TEST_F(Program, RefusesAnUnknownLogLevelInOneLine) {
  const fakes::Finished finished = run({"--log-level", "loud", "--check-config"});

  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.errors.find("axisd: --log-level:"), 0U) << finished.errors;
  EXPECT_EQ(std::ranges::count(finished.errors, '\n'), 1);
}

TEST_F(Program, RefusesValuesOutOfRange) {
  expect_refusal({"--node-id", "-1"}, 2, "--node-id: expected an integer 0 to 127, got -1");
  expect_refusal({"--node-id", "128"}, 2, "--node-id: expected an integer 0 to 127, got 128");
  expect_refusal({"--axes", "0"}, 2, "--axes: expected an integer 1 to 8, got 0");
  expect_refusal({"--axes", "9"}, 2, "--axes: expected an integer 1 to 8, got 9");
}

TEST_F(Program, TakesTheLastInterfaceThatIsNamed) {
  EXPECT_EQ(run({"--check-config", "--interface", "two words", "--interface", "unix:/run/bus"}).status, 0);

  const fakes::Finished finished = run({"--check-config", "--interface", "vcan0", "--interface", "two words"});

  EXPECT_EQ(finished.status, 2);
  EXPECT_NE(finished.errors.find("two words"), std::string::npos) << finished.errors;
}

TEST_F(Program, AcceptsAGoodConfigurationWithoutAWord) {
  std::ofstream{folder.path("node.json")} << R"({"node_id": 5})";

  const fakes::Finished finished = run({"--check-config", "--config", folder.path("node.json")});

  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.output + finished.errors, "");
}

TEST_F(Program, RefusesABadConfigurationInOneLine) {
  const std::string file = folder.path("node.json");
  std::ofstream{file} << R"({"node_id": 200})";

  expect_refusal({"--check-config", "--config", file}, 2,
                 file + ": /node_id: expected an integer 0 to 127, got 200");
  expect_refusal({"--config", file}, 2, file + ": /node_id: expected an integer 0 to 127, got 200");
  expect_refusal({"--check-config", "--config", folder.path()}, 2,
                 folder.path() + ": cannot be read: Is a directory");
}

TEST_F(Program, FailsOnAnInterfaceThatDoesNotExist) {
  const fakes::Finished finished = run({"--interface", "axisdnone0"});

  EXPECT_EQ(finished.status, 1);
  const bool no_can = finished.errors.find("axisd: kernel has no CAN") == 0;
  const bool no_interface = finished.errors.find("axisd: axisdnone0: ") == 0;
  EXPECT_TRUE(no_can || no_interface) << finished.errors;
  EXPECT_EQ(std::ranges::count(finished.errors, '\n'), 1);
}

TEST_F(Program, FailsWithoutAPlaceForItsState) {
  const fakes::Finished finished = fakes::run_program({AXISD, "--interface", "axisdnone0"});

  EXPECT_EQ(finished.status, 1);
  EXPECT_EQ(finished.errors, "axisd: no place for the state: give --state-directory or set HOME\n");
}

}  // namespace
}  // namespace axisd
