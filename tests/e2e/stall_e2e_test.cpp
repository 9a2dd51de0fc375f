// A computer that keeps the daemon from running for a while: masters must not notice more than that it was late.
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

#include "tests/e2e/bus_sdo_client.hpp"
#include "tests/e2e/daemon_process.hpp"
#include "tests/e2e/suspension.hpp"

namespace e2e {
namespace {

using namespace std::chrono_literals;

/// Milliseconds from the signal that stops the daemon to the one that lets it go on.
struct Stall : testing::TestWithParam<std::chrono::milliseconds> {
  static constexpr int kTries = 20;
  static constexpr std::chrono::milliseconds kBetweenFrames{10};

  void SetUp() override { ASSERT_TRUE(daemon.is_ready()); }
  /// Stops the daemon and waits until it stands.
  void stop() const { suspend(daemon); }
  void daemon_signal(int signal) const { daemon.program().signal(signal); }
  /// Returns when the frame has passed the bus, so that it waits for the daemon.
  testing::AssertionResult pass(const char* frame) {
    can.send(frame);
    return witness.wait_for(frame);
  }

  CanClient can{kTestInterface};
  CanClient witness{kTestInterface};
  mutable DaemonProcess daemon;
};

TEST_P(Stall, TakesNoControlwordOfAStartAway) {
  can.send("000#0105");
  ASSERT_TRUE(wait_for_state(can, kSwitchOnDisabled));
  int enabled = 0;
  for (int i = 0; i < kTries; ++i) {
    // The drive rests by now, or it does not: both must be right.
    if (i % 2 == 0) std::this_thread::sleep_for(5 * kBetweenFrames);
    can.forget();

    stop();
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_TRUE(pass("205#0600"));
    for (const char* const controlword : {"205#0700", "205#0F00"}) {
      std::this_thread::sleep_for(kBetweenFrames);  // never less, or the unit would rightly miss one
      ASSERT_TRUE(pass(controlword));
    }
    std::this_thread::sleep_until(begin + GetParam());
    daemon_signal(SIGCONT);

    ASSERT_TRUE(wait_for_state(can, kOperationEnabled)) << "try " << i;
    ++enabled;
    can.send("205#0000");
    ASSERT_TRUE(wait_for_state(can, kSwitchOnDisabled));
  }
  EXPECT_EQ(enabled, kTries);
  EXPECT_EQ(daemon.bus_counter("lost_telegrams"), 0U);
}
INSTANTIATE_TEST_SUITE_P(Ms, Stall, testing::Values(20ms, 50ms, 90ms),
                         [](const auto& test) { return std::to_string(test.param.count()); });

TEST(SlowDisk, IsWaitedForBesideTheCycles) {
  const fakes::TemporaryDirectory folder;
  const std::string gate = folder.path("gate");
  CanClient can{kTestInterface};
  CanClient answers{kTestInterface};
  answers.listen_to({0x585});
  DaemonProcess daemon{{.environment = {std::string{"LD_PRELOAD="} + SLOW_DISK, "SLOW_DISK_GATE=" + gate}}};
  ASSERT_TRUE(daemon.is_ready());

  can.send("605#2310100173617665");  // "save"
  ASSERT_NO_FATAL_FAILURE(make_motor_turn(can));

  EXPECT_FALSE(answers.next_waiting()) << "it is not on the disk";
  std::ofstream{gate} << "open";
  EXPECT_TRUE(answers.expect("585#6010100100000000"));
}

}  // namespace
}  // namespace e2e
