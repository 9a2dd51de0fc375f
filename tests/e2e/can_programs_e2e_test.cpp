#include <chrono>
#include <fstream>

#include <fmt/format.h>

#include "tests/e2e/daemon_process.hpp"

namespace e2e {
namespace {

/// What people use SocketCAN with, unmodified, beside a daemon.
struct CanPrograms : RunningDaemon {
  /// Between frames for a program of which nothing tells when it listens: a flood of them would fill its socket.
  static constexpr std::chrono::milliseconds kPause{20};

  static void SetUpTestSuite() { start(); }

  /// Runs @p words to their end, in the environment of the bus.
  static fakes::Finished run(const std::vector<std::string>& words) {
    return fakes::run_program(words, bus_environment());
  }
  /// Starts candump, and returns when it records.
  static std::unique_ptr<Program> candump(const std::vector<std::string>& options = {"-L"}) {
    std::vector<std::string> words{"/usr/bin/candump"};
    words.insert(words.end(), options.begin(), options.end());
    words.emplace_back(kTestInterface);
    auto program = std::make_unique<Program>(words, bus_environment());
    do can->send("7FF#");
    while (!program->wait_for_output("7FF", 0, kPause));
    return program;
  }
};

TEST_F(CanPrograms, CandumpTellsWhoSentAndWhen) {
  const auto record = candump({"-x", "-t", "a"});

  can->send("605#4000100000000000");

  EXPECT_TRUE(record->wait_for_output("  vcan0  TX - -  605   [8]  40 00 10 00 00 00 00 00\n"))
      << record->output();
  EXPECT_TRUE(record->wait_for_output("  vcan0  TX - -  585   [8]  43 00 10 00 92 01 FF FF\n"))
      << record->output();
  EXPECT_EQ(record->output().find("(0"), std::string::npos);  // no time of 1970
}

TEST_F(CanPrograms, CangenSendsWhatIsAskedFor) {
  const auto record = candump();

  EXPECT_EQ(run({"/usr/bin/cangen", kTestInterface, "-g", "1", "-I", "605", "-D", "4008100000000000", "-L", "8",
                 "-n", "3"})
                .status,
            0);

  for (int i = 0; i < 3; ++i) EXPECT_TRUE(can->wait_for("585#4108100008000000"));
  EXPECT_TRUE(record->wait_for_output(" vcan0 605#4008100000000000\n"));
}

TEST_F(CanPrograms, CangenAsFastAsItCanIsHeardByTheDaemon) {
  EXPECT_EQ(run({"/usr/bin/cangen", kTestInterface, "-g", "0", "-p", "10000", "-I", "123", "-n", "2000"}).status,
            0);

  EXPECT_TRUE(can->ask("605#4000100000000000", "585#430010009201FFFF"));
}

TEST_F(CanPrograms, CansequenceCountsItsFrames) {
  EXPECT_EQ(run({"/usr/bin/cansequence", "--loop=3", kTestInterface}).status, 0);

  for (const char* const frame : {"002#00", "002#01", "002#02"}) EXPECT_TRUE(can->expect(frame));
}

TEST_F(CanPrograms, CansequenceMissesNoFrame) {
  Program receiver{{"/usr/bin/cansequence", "-r", "--quit", "--loop=20", kTestInterface}, bus_environment()};

  constexpr int kMostFrames = 2000;
  int count = 0;
  do can->send(fmt::format("002#{:02X}", count % 0x100));
  while (!receiver.ends_within(kPause) && ++count < kMostFrames);

  EXPECT_EQ(receiver.wait(), 0) << receiver.output();
}

TEST_F(CanPrograms, CanplayerPlaysALog) {
  const std::string log = daemon->path("candump.log");
  std::ofstream{log} << "(1436509052.249713) vcan0 605#4000100000000000\n"
                        "(1436509052.259847) vcan0 605#4018100100000000\n"
                        "(1436509052.269953) vcan0 705#R\n";

  EXPECT_EQ(run({"/usr/bin/canplayer", "-I", log}).status, 0);

  EXPECT_TRUE(can->wait_for("585#430010009201FFFF"));
  EXPECT_TRUE(can->wait_for("585#4318100153000006"));
}

TEST_F(CanPrograms, CansnifferShowsWhatChanges) {
  Program sniffer{{"/usr/bin/cansniffer", "-c", "-t", "0", kTestInterface}, bus_environment()};
  Program requests{
      {"/usr/bin/cangen", kTestInterface, "-g", "20", "-I", "605", "-D", "4000100000000000", "-L", "8"},
      bus_environment()};

  EXPECT_TRUE(sniffer.wait_for_output("585")) << sniffer.output();
  EXPECT_TRUE(sniffer.wait_for_output("92 01 FF FF")) << sniffer.output();
}

TEST_F(CanPrograms, PythonCanIsAMaster) {
  const fakes::Finished master = run({"/usr/bin/python3", PYTHON_CAN_SCRIPT, kTestInterface});

  EXPECT_EQ(master.status, 0) << "python3 with the package python3-can:\n" << master.output << master.errors;
}

}  // namespace
}  // namespace e2e
