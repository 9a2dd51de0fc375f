#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "can/userbus/time.hpp"
#include "tests/can/hub/running_hub.hpp"
#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "version/version.hpp"

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
                                   "--socketcand HOST:PORT", "--time TIME", "$XDG_RUNTIME_DIR/can-bus"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;

  const Finished asked = canhub({"--version"});
  EXPECT_EQ(asked.status, 0);
  EXPECT_EQ(asked.output, version::line("canhub") + "\n");
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
    testing::Values(
        Wrong{"LongPath",
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
        Wrong{"Time",
              {"--time", "scaled=0"},
              "--time: expected real, scaled=K (0.001 to 1000), virtual or stepped, got \"scaled=0\""},
        Wrong{"TimeAndNoBitRate",
              {"--time", "stepped", "--bitrate", "0"},
              "--time virtual and stepped need a --bitrate above 0: only if frames take time does it go on"},
        Wrong{"TimeAndBridge",
              {"--time", "virtual", "--bridge", "unix:/tmp/other"},
              "--bridge, --socketcand and --join need --time real: what they lead to has the machine's time"},
        Wrong{"TimeAndSocketcand",
              {"--time", "scaled=2", "--socketcand", "127.0.0.1:0"},
              "--bridge, --socketcand and --join need --time real: what they lead to has the machine's time"},
        Wrong{"TimeAndJoin",
              {"--time", "virtual", "--join", "nats://127.0.0.1/bus"},
              "--bridge, --socketcand and --join need --time real: what they lead to has the machine's time"},
        Wrong{"TakeBack", {"--take-back", "x"}, "--take-back: expected the number of a fault or all, got \"x\""},
        Wrong{"InjectAndServe",
              {"--inject", "bus.drop", "--bitrate", "125000"},
              "--inject, --injected and --take-back speak to a running hub: beside --path and --json they "
              "go with each other only"},
        Wrong{"Json", {"--json"}, "--json goes with --injected"},
        Wrong{"WithOnDemand",
              {"--on-demand", "--with", "bus.drop"},
              "--on-demand does not go with --with, whose faults nobody would see refused"},
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

TEST(CanhubCommand, PrintsTheTimeOfARunningHub) {
  RunningHub hub{hub::Server::Settings{.bit_rate = 1'000'000, .time = {userbus::TimeMode::Stepped, 1}}};
  const userbus::JoinedClock clock = userbus::join_clock(path_of(hub.path()), nullptr, 0, getpid(), false);
  const os::Descriptor program{clock.descriptor};
  userbus::TimeTurn turn{};
  ASSERT_EQ(userbus::take_turn(program.get(), true, turn), userbus::TurnOutcome::Turn);

  const Finished acting = canhub({"--status", "--path", hub.path()});

  EXPECT_NE(acting.output.find("\ntime: stepped, 0.000000000 s since its start, process " +
                               std::to_string(getpid()) + " has its turn\n"),
            std::string::npos)
      << acting.output;
  EXPECT_NE(acting.output.find("\nclock "), std::string::npos) << acting.output;

  RunningHub scaled{hub::Server::Settings{.time = {userbus::TimeMode::Scaled, 2.5}}};
  const Finished quick = canhub({"--status", "--path", scaled.path()});
  EXPECT_NE(quick.output.find("\ntime: scaled, 2.5 times as quick\n"), std::string::npos) << quick.output;
}

TEST(CanhubCommand, IsNotStartedForATimeThatIsNone) {
  const fakes::TemporaryDirectory folder;
  setenv("CAN_TIME", "soon", 1);
  const userbus::Joined joined =
      userbus::join(path_of(folder.path("bus")), CANHUB, userbus::Kind::Raw, SOCK_CLOEXEC);
  unsetenv("CAN_TIME");
  EXPECT_LT(joined.descriptor, 0);
  EXPECT_STREQ(
      userbus::text_of(joined.error),
      "is not served, and CAN_TIME is no time: expected real, scaled=K (0.001 to 1000), virtual or stepped");
}

TEST(CanhubCommand, InjectsListsAndTakesBackFaults) {
  RunningHub hub;
  const auto ask = [&hub](std::vector<std::string> words) {
    words.insert(words.end(), {"--path", hub.path()});
    return canhub(std::move(words));
  };

  const Finished injected =
      ask({"--inject", "bus.drop id=185 after=1 times=1", "--inject", R"({"kind": "bus.duplicate"})"});
  EXPECT_EQ(injected.output, "1\n2\n");
  EXPECT_EQ(injected.status, 0);
  BusClient sender{hub.path()}, receiver{hub.path()};
  for (const char* const frame : {"185#01", "185#02", "185#03"}) sender.send(frame);
  sender.settle();
  EXPECT_EQ(receiver.take_frames(), (std::vector<std::string>{"185#01", "185#01", "185#03", "185#03"}));
  EXPECT_EQ(ask({"--injected"}).output,
            "  id state        seen     hits  fault\n"
            "   1 over            1        1  bus.drop after=1 id=0x185 times=1\n"
            "   2 active          3        3  bus.duplicate\n");
  EXPECT_EQ(ask({"--take-back", "2", "--injected", "--json"}).output,
            R"({"faults":[{"events":2,"fault":{"after":1,"id":"0x185","kind":"bus.drop","times":1},"hit_at":[1],)"
            R"("hits":1,"id":1,"opportunities":1,"state":"over"}]})"
            "\n");
  EXPECT_EQ(ask({"--take-back", "all", "--injected"}).output, "no faults\n");
}

TEST(CanhubCommand, SaysWhatIsWrongWithAFault) {
  RunningHub hub;
  const Finished kind = canhub({"--path", hub.path(), "--inject", "bus.load percent=5"});
  EXPECT_EQ(kind.status, 2);
  EXPECT_EQ(kind.errors,
            "canhub: --inject: expected a bus with a bit rate for a share of its time, got one without\n");
  const Finished number = canhub({"--path", hub.path(), "--take-back", "7"});
  EXPECT_EQ(number.status, 2);
  EXPECT_EQ(number.errors, "canhub: --take-back: id: expected the number of a fault, got 7\n");

  const fakes::TemporaryDirectory folder;
  const Finished served = canhub({"--path", folder.path("bus"), "--with", "bus.delay"});
  EXPECT_EQ(served.status, 2);
  EXPECT_NE(
      served.errors.find("canhub: --with: delay_ms: expected a whole number from 1 to 3600000, got nothing\n"),
      std::string::npos);
  const Finished nobody = canhub({"--path", folder.path("bus"), "--injected"});
  EXPECT_EQ(nobody.status, 1);
  EXPECT_EQ(nobody.errors, "canhub: " + folder.path("bus") + ": is not served\n");
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
