#include <fstream>

#include <gtest/gtest.h>

#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

/// canrec as a user meets it, without a server and without a bus.
namespace {

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
  std::vector<std::string> words = GetParam().words;
  words.insert(words.begin(), CANREC);
  const fakes::Finished finished = fakes::run_program(words);
  EXPECT_EQ(finished.status, GetParam().status);
  EXPECT_EQ(finished.errors, std::string{"canrec: "} + GetParam().message + "\n");
  EXPECT_EQ(finished.output, "");
}

INSTANTIATE_TEST_SUITE_P(
    Canrec, Mistakes,
    testing::Values(
        Mistake{"Nothing", {}, "expected a subcommand: record, stop, list, remove, export, import, play"},
        Mistake{"NoSubcommand",
                {"rekord", "x"},
                "expected a subcommand: record, stop, list, remove, export, import, play, got \"rekord\""},
        Mistake{"RecordNothing", {"record"}, "BUS is required"},
        Mistake{"RecordWithoutName", {"record", "nats://localhost/lab"}, "RECORDING is required"},
        Mistake{"NoUrl",
                {"record", "lab", "x"},
                "expected nats://HOST[:PORT]/NAME or tls://HOST[:PORT]/NAME, got \"lab\""},
        Mistake{"NoRecording",
                {"export", "nats://localhost"},
                "expected nats://HOST[:PORT]/RECORDING or tls://HOST[:PORT]/RECORDING, got \"nats://localhost\""},
        Mistake{"ListOfOne",
                {"list", "nats://localhost/x"},
                "expected nats://HOST[:PORT] or tls://HOST[:PORT], got \"nats://localhost/x\""},
        Mistake{"NoNameOfARecording",
                {"record", "nats://localhost/lab", "a.b"},
                "RECORDING: expected a name of 1 to 32 letters, digits, '-' and '_', got \"a.b\""},
        Mistake{
            "AnotherHostInThePlain",
            {"list", "nats://192.0.2.1"},
            "192.0.2.1 is another host, and everybody on the way can read and write there: tls://, or --plain"},
        Mistake{"HalfACertificate",
                {"list", "nats://localhost", "--tls-cert", "x"},
                "--tls-cert and --tls-key go with each other"},
        Mistake{"NoAge",
                {"record", "nats://localhost/lab", "x", "--max-age", "0"},
                "--max-age: expected seconds or a time as 15m, 12h or 7d, got \"0\""},
        Mistake{"NoBytes",
                {"record", "nats://localhost/lab", "x", "--max-bytes", "many"},
                "--max-bytes: expected bytes, a number as 500M or 2G, or 0 for no limit, got \"many\""},
        Mistake{"SpeedOfZero",
                {"play", "x.log", "--onto", "vcan0", "--speed", "0"},
                "--speed: expected a number above 0, up to 1000000, got \"0\"; --fast does not wait at all"},
        Mistake{"SpeedAndFast",
                {"play", "x.log", "--onto", "vcan0", "--speed", "2", "--fast"},
                "--speed excludes --fast"},
        Mistake{"NoMoment",
                {"play", "x.log", "--onto", "vcan0", "--from", "soon"},
                "--from: expected seconds behind the first frame, or @ and a time stamp of the log, got \"soon\""},
        Mistake{"NoBusOfThatName",
                {"play", "x.log", "--onto", "udp-multicast://x"},
                "--onto: expected a port 1 to 65535 behind the group, got \"udp-multicast://x\""},
        Mistake{"OntoNothing", {"play", "x.log"}, "--onto is required"},
        Mistake{"CredentialsForAFile",
                {"play", "x.log", "--onto", "vcan0", "--credentials", "x"},
                "--credentials, --tls-... and --plain go with a URL"},
        Mistake{"NoFile",
                {"play", "/nowhere/x.log", "--onto", "vcan0"},
                "/nowhere/x.log: No such file or directory",
                1},
        Mistake{"NoRegularFile",
                {"import", "/dev/null", "nats://localhost/x"},
                "/dev/null: expected a log of candump, this is no regular file",
                1}),
    [](const testing::TestParamInfo<Mistake>& each) { return std::string{each.param.name}; });

/// Plays a log with @p text onto a bus that is not there.
fakes::Finished play(const std::string& text, const std::vector<std::string>& more = {}) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("x.log");
  std::ofstream{path} << text;
  std::vector<std::string> words{CANREC, "play", path, "--onto", "unix:/nowhere/bus", "--fast"};
  words.insert(words.end(), more.begin(), more.end());
  fakes::Finished finished = fakes::run_program(words);
  for (std::size_t at; (at = finished.errors.find(folder.path())) != std::string::npos;)
    finished.errors.erase(at, folder.path().size() + 1);
  return finished;
}

constexpr const char* kNoBus =
    "canrec: unix:/nowhere/bus: cannot be served by canhub (run canhub --path to see why)\n";

TEST(CanrecPlay, SaysThatTheBusIsNotThere) {
  const fakes::Finished finished = play("(1.0) can0 123#11\n");
  EXPECT_EQ(finished.status, 6);
  EXPECT_EQ(finished.errors, kNoBus);
}

TEST(CanrecPlay, RefusesADamagedLogBeforeAnythingIsSent) {
  const fakes::Finished finished = play("(1.0) can0 123#11\n(2.0) can0 12");
  EXPECT_EQ(finished.status, 5);
  EXPECT_EQ(
      finished.errors,
      "canrec: x.log:2: expected a frame as 123#1122, 12345678#1122 or 123#R behind the interface, got \"(2.0) "
      "can0 12\"\n");
}

TEST(CanrecPlay, LeavesOutDamagedLinesIfItIsTold) {
  std::string log = "(1.0) can0 123#11\n";
  for (int i = 0; i < 12; ++i) log += "x\n";
  const fakes::Finished finished = play(log, {"--skip-damaged"});
  EXPECT_EQ(finished.status, 6);
  EXPECT_NE(finished.errors.find("canrec: x.log:11: expected (SECONDS"), std::string::npos) << finished.errors;
  EXPECT_EQ(finished.errors.find("canrec: x.log:12:"), std::string::npos) << finished.errors;
  EXPECT_NE(finished.errors.find("canrec: x.log: 12 damaged lines are left out\n"), std::string::npos);
}

TEST(CanrecPlay, WantsAFrame) {
  EXPECT_EQ(play("").errors, "canrec: x.log: expected a log of candump, there is no frame in it\n");
  EXPECT_EQ(play("(1.0) can0 123#11\n", {"--interface", "can7"}).errors,
            "canrec: x.log: expected a log of candump with frames of can7, there is no frame in it\n");
}

}  // namespace
