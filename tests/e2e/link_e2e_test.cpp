#include <csignal>

#include "tests/e2e/daemon_process.hpp"
#include "tests/e2e/suspension.hpp"
#include "tests/support/network.hpp"

namespace e2e {
namespace {

using network::VirtualCan;

constexpr const char* kInterface = "vcan7";
constexpr const char* kDown = "vcan7 is down";
constexpr std::uint64_t kCycles = 200;        // of 4 ms
constexpr double kGain = 100.0;               // rpm; the ramp gains 720 rpm/s
constexpr std::uint64_t kTicksASecond = 100;  // USER_HZ

/// An interface of its own that is taken away from a running daemon.
struct Link : testing::Test {
  VirtualCan interface { kInterface };

  static DaemonOptions options() { return {.interface = kInterface, .environment = {"WATCHDOG_USEC=1000000"}}; }
  /// Brings the motor up to a speed, so that there is something to compute while nobody listens.
  static void turn_motor(CanClient& can) {
    can.send("000#0105");
    ASSERT_TRUE(wait_for_state(can, kSwitchOnDisabled));
    can.send("205#0600");
    ASSERT_TRUE(wait_for_state(can, kReadyToSwitchOn));
    can.send("205#0700");
    ASSERT_TRUE(wait_for_state(can, kSwitchedOn));
    can.send("305#0F000000800C");
    ASSERT_TRUE(wait_for_drive(can, "a turning motor", [](const StatusAndSpeed& drive) {
      return drive.is(kOperationEnabled) && drive.speed > 0;
    }));
  }
  /// Processor ticks that the daemon uses within a second, as its watchdog messages tell the time.
  static std::uint64_t ticks_in_a_second(DaemonProcess& daemon) {
    EXPECT_TRUE(daemon.notify().wait_for("WATCHDOG=1"));
    const std::uint64_t before = daemon.program().processor_ticks();
    EXPECT_TRUE(daemon.notify().wait_for("WATCHDOG=1"));  // every half second
    EXPECT_TRUE(daemon.notify().wait_for("WATCHDOG=1"));
    return daemon.program().processor_ticks() - before;
  }
  static void expect_alive() {
    CanClient can{kInterface};
    EXPECT_TRUE(can.ask("605#4000100000000000", "585#430010009201FFFF"));
  }
  /// The interface is set up while somebody listens who hears the boot-up message.
  void expect_boot_up_when_set_up(DaemonProcess& daemon) const {
    CanClient can{kInterface};
    interface.up();
    EXPECT_TRUE(can.wait_for("705#00"));
    EXPECT_TRUE(daemon.program().wait_for_output("vcan7 is up again"));
    expect_alive();
  }
};

TEST_F(Link, BootsAgainWhenTheInterfaceIsBack) {
  DaemonProcess daemon{options()};
  ASSERT_TRUE(daemon.is_ready());

  interface.down();

  ASSERT_TRUE(daemon.program().wait_for_output(kDown));
  EXPECT_LT(ticks_in_a_second(daemon), kTicksASecond / 10);
  EXPECT_EQ(daemon.log_lines(kDown), 1u);
  EXPECT_EQ(daemon.status().at("bus").at("link"), "down");
  expect_boot_up_when_set_up(daemon);
}

TEST_F(Link, TakesWithItWhatWaitedInTheSocket) {
  DaemonProcess daemon{options()};
  ASSERT_TRUE(daemon.is_ready());

  suspend(daemon);
  CanClient before{kInterface};
  before.send("000#0105");
  before.send("605#2B17100064000000");
  interface.down();
  daemon.program().signal(SIGCONT);

  ASSERT_TRUE(daemon.program().wait_for_output(kDown));
  expect_boot_up_when_set_up(daemon);
  EXPECT_EQ(daemon.status().at("nmt_state"), "Pre-operational");
  CanClient after{kInterface};
  EXPECT_TRUE(after.ask("605#4017100000000000", "585#4B17100000000000"));
}

TEST_F(Link, CanBeLostWhileTheMotorTurns) {
  DaemonProcess daemon{options()};
  ASSERT_TRUE(daemon.is_ready());
  {
    CanClient can{kInterface};
    ASSERT_TRUE(can.ask("605#2B1710000A000000", "585#6017100000000000"));  // heartbeat every 10 ms
    turn_motor(can);
  }

  interface.down();

  ASSERT_TRUE(daemon.program().wait_for_output(kDown));
  EXPECT_LT(ticks_in_a_second(daemon), kTicksASecond / 2);
  EXPECT_EQ(daemon.log_lines(kDown), 1u);
  expect_boot_up_when_set_up(daemon);
}

TEST_F(Link, IsNotNeededForTheMotorToTurn) {
  DaemonProcess daemon{{.interface = kInterface}};
  ASSERT_TRUE(daemon.is_ready());
  {
    CanClient can{kInterface};
    turn_motor(can);
  }
  interface.down();
  ASSERT_TRUE(daemon.program().wait_for_output(kDown));

  const auto speed = [&] { return daemon.status().at("axes").at(0).at("speed_rpm").get<double>(); };
  const double before = speed();

  ASSERT_TRUE(daemon.program().wakes(kCycles));  // by itself: a request would wake it too

  EXPECT_GT(speed(), before + kGain);
}

TEST_F(Link, MayBeDownAtTheStart) {
  interface.down();
  DaemonProcess daemon{options()};

  ASSERT_TRUE(daemon.program().wait_for_output(kDown));
  EXPECT_LT(ticks_in_a_second(daemon), kTicksASecond / 10);
  EXPECT_EQ(daemon.log_lines(kDown), 1u);
  EXPECT_EQ(daemon.log_lines("ready"), 0u);
  for (const std::string& message : daemon.notify().messages())
    EXPECT_EQ(message.find("READY"), std::string::npos);

  CanClient can{kInterface};
  interface.up();
  EXPECT_TRUE(daemon.is_ready());
  EXPECT_TRUE(can.wait_for("705#00"));
  expect_alive();
}

TEST_F(Link, SurvivesThatTheInterfaceIsRemovedAndMadeAgain) {
  DaemonProcess daemon{options()};
  ASSERT_TRUE(daemon.is_ready());

  interface.remove();

  ASSERT_TRUE(daemon.program().wait_for_output(kDown));
  EXPECT_LT(ticks_in_a_second(daemon), kTicksASecond / 10);
  EXPECT_EQ(daemon.log_lines(kDown), 1u);

  interface.create();
  EXPECT_TRUE(daemon.program().wait_for_output("vcan7 is up again"));
  expect_alive();
}

TEST_F(Link, CanBeDownWhenTheDaemonEnds) {
  DaemonProcess daemon{options()};
  ASSERT_TRUE(daemon.is_ready());
  interface.down();
  ASSERT_TRUE(daemon.program().wait_for_output(kDown));

  EXPECT_EQ(daemon.end(SIGTERM), 0);
}

}  // namespace
}  // namespace e2e
