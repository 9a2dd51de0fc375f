#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/can/hub/running_hub.hpp"
#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace hub_test {
namespace {

using fakes::Finished;

Finished canhub(std::vector<std::string> words, const std::vector<std::string>& environment = {}) {
  words.insert(words.begin(), CANHUB);
  return fakes::run_program(words, environment);
}

TEST(CanhubCommand, PrintsHelpAndVersion) {
  const Finished help = canhub({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* const option : {"--path PATH", "--bitrate N", "--on-demand", "--bridge URL", "--status",
                                   "--socketcand HOST:PORT", "$XDG_RUNTIME_DIR/can-bus"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;

  const Finished version = canhub({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.output, "canhub " AXISD_VERSION "\n");
}

/// A command line that cannot be used.
struct Wrong {
  const char* name;
  std::vector<std::string> words;
  std::string message;
};

void PrintTo(const Wrong& row, std::ostream* out) {
  *out << row.name;
}

class WrongCommands : public testing::TestWithParam<Wrong> {};

TEST_P(WrongCommands, AreAnsweredWithOneLineAndStatus2) {
  const Finished finished = canhub(GetParam().words);

  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.errors, "canhub: " + GetParam().message + '\n');
}

INSTANTIATE_TEST_SUITE_P(
    Words, WrongCommands,
    testing::Values(Wrong{"LongPath",
                          {"--path", '/' + std::string(107, 'x')},
                          "--path: a path of 108 bytes is too long for a socket, 107 is the most"},
                    Wrong{"EmptyPath", {"--path", ""}, "--path: expected a path, got nothing"},
                    Wrong{"Word",
                          {"--bitrate", "fast"},
                          "--bitrate: expected 0 or an integer 1000 to 1000000 (bit/s), got \"fast\""},
                    Wrong{"HighRate",
                          {"--bitrate", "1000001"},
                          "--bitrate: expected 0 or an integer 1000 to 1000000 (bit/s), got \"1000001\""},
                    Wrong{"LowRate",
                          {"--bitrate", "999"},
                          "--bitrate: expected 0 or an integer 1000 to 1000000 (bit/s), got \"999\""},
                    Wrong{"Unknown", {"--nonsense"}, "The following argument was not expected: --nonsense"}),
    [](const auto& row) { return std::string{row.param.name}; });

TEST(CanhubCommand, TakesThePathFromTheEnvironment) {
  const fakes::TemporaryDirectory folder;
  const Finished bus = canhub({"--status"}, {"CAN_BUS=" + folder.path("a"), "XDG_RUNTIME_DIR=/run/user/0"});
  const Finished folder_only = canhub({"--status"}, {"CAN_BUS=", "XDG_RUNTIME_DIR=" + folder.path()});
  const Finished too_long = canhub({"--status"}, {"XDG_RUNTIME_DIR=/" + std::string(107, 'x')});

  EXPECT_EQ(bus.status, 1);
  EXPECT_EQ(bus.errors, "canhub: " + folder.path("a") + ": is not served\n");
  EXPECT_EQ(folder_only.errors, "canhub: " + folder.path("can-bus") + ": is not served\n");
  EXPECT_EQ(too_long.status, 2);
}

TEST(CanhubCommand, PrintsTheStatusOfARunningHub) {
  RunningHub hub{125'000};
  BusClient member{hub.path(), "vcan0"};
  member.set(userbus::OptionName::OwnMessages);
  member.send("123#");
  ASSERT_EQ(member.wait_frame(), "123#");

  const Finished status = canhub({"--status", "--path", hub.path()});

  EXPECT_EQ(status.status, 0);
  const std::string process = std::to_string(getpid());
  EXPECT_EQ(status.output,
            "bus " + hub.path() + ": 125000 bit/s, 1 frames\n" +
                "member                        pid interface             sent   received  dropped  refused\n" +
                "raw                      " + std::string(8 - process.size(), ' ') + process +
                " vcan0                    1          1        0        0\n");
}

TEST(CanhubCommand, SaysWhatIsAtThePath) {
  const fakes::TemporaryDirectory folder;
  const Finished finished = canhub({"--path", folder.path("none/bus")});

  EXPECT_EQ(finished.status, 1);
  EXPECT_EQ(finished.errors,
            "canhub: " + folder.path("none/bus.lock") + ": cannot be locked: No such file or directory\n");
}

}  // namespace
}  // namespace hub_test
