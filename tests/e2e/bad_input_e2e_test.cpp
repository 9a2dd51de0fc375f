#include <algorithm>
#include <iostream>
#include <random>

#include "tests/e2e/daemon_process.hpp"
#include "tests/fakes/candump.hpp"

namespace e2e {
namespace {

constexpr const char* kAskDeviceType = "605#4000100000000000";
constexpr const char* kDeviceType = "585#430010009201FFFF";

std::ptrdiff_t line_count(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

struct Refusal : testing::Test {
  CanClient can{kTestInterface};
  DaemonProcess daemon;
  fakes::TemporaryDirectory elsewhere;

  void SetUp() override { ASSERT_TRUE(daemon.is_ready()); }
  fakes::Finished start_second(const std::string& state) const {
    return run_axisd({"--interface", served_interface(), "--node-id", "5", "--state-directory", state, "--control",
                      elsewhere.path("ctl")});
  }
  void expect_refused(const fakes::Finished& second) {
    EXPECT_EQ(second.status, 1);
    EXPECT_EQ(line_count(second.errors), 1) << second.errors;
    EXPECT_NE(second.errors.find(served_interface() + ": node 5 is served by another axisd"), std::string::npos)
        << second.errors;
    EXPECT_TRUE(can.ask(kAskDeviceType, kDeviceType));
  }
};

TEST_F(Refusal, OfASecondDaemonWithTheSameState) {
  expect_refused(start_second(daemon.path("state")));
}

TEST_F(Refusal, OfASecondDaemonWithItsOwnState) {
  expect_refused(start_second(elsewhere.path("state")));
}

TEST(CommandLine, RefusesAnInterfaceThatDoesNotExist) {
  const fakes::TemporaryDirectory folder;

  const auto finished = run_axisd({"--interface", "nosuch0", "--state-directory", folder.path()});

  EXPECT_EQ(finished.status, 1);
  EXPECT_EQ(finished.errors, "axisd: nosuch0: no such CAN interface\n");
}

TEST(CommandLine, RefusesAnInterfaceThatIsNoCan) {
  const fakes::TemporaryDirectory folder;

  const auto finished = run_axisd({"--interface", "lo", "--state-directory", folder.path()});

  EXPECT_EQ(finished.status, 1);
  EXPECT_EQ(finished.errors, "axisd: lo: not a CAN interface\n");
}

TEST(CommandLine, RefusesNodeIdsOutsideZeroTo127) {
  for (const char* const node : {"-1", "128"}) {
    const auto finished = run_axisd({"--node-id", node});
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(line_count(finished.errors), 1) << finished.errors;
  }
}

struct OddFrames : RunningDaemon {
  static void SetUpTestSuite() { start(); }
};

TEST_F(OddFrames, AreIgnored) {
  for (const char* const text : {"605#",
                                 "605#40",
                                 "605#40001000000000",
                                 "605#R",
                                 "605#R8",
                                 "205#",
                                 "205#06",
                                 "205#R2",
                                 "305#0F00",
                                 "000#",
                                 "000#01",
                                 "000#010500",
                                 "000#R2",
                                 "080#0102",
                                 "080#R",
                                 "085#R8",
                                 "185#R2",
                                 "123#11",
                                 "7E5#04",
                                 "00000605#4000100000000000",
                                 "00000205#0600",
                                 "00000000#8105",
                                 "12340605#4000100000000000"}) {
    can->send(text);
  }

  can->send(kAskDeviceType);

  // The first frame that comes is the answer: no boot-up, no other statusword, no answer to any of those above.
  const auto answer = can->next();
  ASSERT_TRUE(answer);
  EXPECT_EQ(fakes::candump(*answer), kDeviceType);
}

TEST_F(OddFrames, OfAGuardingMasterMayHaveAnyLength) {
  EXPECT_TRUE(can->ask("705#R", "705#05"));
  EXPECT_TRUE(can->ask("705#R1", "705#85"));
}

/// Bytes that a master should not send: commands of every kind, indices that exist and that do not.
canopen::Frame random_request(std::mt19937& random) {
  const auto byte = [&random] { return static_cast<std::uint8_t>(random()); };
  canopen::Frame frame{.id = 0x605, .length = static_cast<std::uint8_t>(random() % 4 == 0 ? random() % 9 : 8)};
  for (std::size_t i = 0; i < frame.length; ++i) frame.data[i] = byte();
  constexpr std::array<std::uint16_t, 8> kIndices{0x1000, 0x1003, 0x1008, 0x1018, 0x1400, 0x1A00, 0x6040, 0x60FF};
  if (frame.length == 8 && random() % 2 == 0) {
    const std::uint16_t index = kIndices[random() % kIndices.size()];
    frame.data[1] = static_cast<std::uint8_t>(index);
    frame.data[2] = static_cast<std::uint8_t>(index >> 8);
    frame.data[3] = static_cast<std::uint8_t>(random() % 3);
  }
  return frame;
}

TEST_F(OddFrames, OfTheSdoClientLeaveTheServerAlive) {
  const auto seed = std::random_device{}();
  std::cout << "seed " << seed << '\n';
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random{seed};
  constexpr int kRounds = 30;
  constexpr int kRequestsARound = 100;

  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kRequestsARound; ++i) can->send(random_request(random));
    can->send("605#8000000000000008");  // whatever is open
    can->send(kAskDeviceType);
    ASSERT_TRUE(can->wait_for(kDeviceType));
    can->forget();
  }
}

struct DuplicateNode : testing::Test, testing::WithParamInterface<const char*> {};

TEST_P(DuplicateNode, IsLogged) {
  CanClient can{kTestInterface};
  DaemonProcess daemon;
  ASSERT_TRUE(daemon.is_ready());

  can.send(GetParam());

  EXPECT_TRUE(daemon.program().wait_for_output("duplicate node-ID")) << daemon.program().output();
  EXPECT_EQ(daemon.bus_counter("foreign"), 1u);
  EXPECT_TRUE(can.ask(kAskDeviceType, kDeviceType));
}
INSTANTIATE_TEST_SUITE_P(HeartbeatAndSdo, DuplicateNode, testing::Values("705#05", "585#430010009201FFFF"));

}  // namespace
}  // namespace e2e
